//! A tree of bounding boxes over items that have one each.

use glam::Vec3;

/// Items of a leaf, at most.
const LEAF: usize = 4;
/// Halving 2^32 items ends after 32 levels; the walk keeps one sibling a level.
const DEEPEST: usize = 64;

/// A box that holds others, or a run of items.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Node {
    pub(crate) low: Vec3,
    pub(crate) high: Vec3,
    /// Of a leaf: its first item, in the tree's order. Else: its second child; the first follows it.
    pub(crate) first: u32,
    /// Items of a leaf; 0 else.
    pub(crate) count: u32,
}

/// The tree: nodes before their children, items in an order of its own.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    order: Vec<u32>,
}

/// Box of an item.
type Bounds = (Vec3, Vec3);

impl Node {
    fn distance_squared(&self, point: Vec3) -> f32 {
        (self.low - point).max(point - self.high).max(Vec3::ZERO).length_squared()
    }
    pub(crate) fn items(&self) -> std::ops::Range<u32> {
        self.first..self.first + self.count
    }
}

impl Bvh {
    pub(crate) fn new(boxes: &[Bounds]) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        let mut order = std::mem::take(&mut tree.order);
        if !order.is_empty() {
            tree.split(boxes, &mut order, 0);
        }
        tree.order = order;
        tree
    }

    /// Adds the node of these items and all below it; `first` is the place of the first of them.
    fn split(&mut self, boxes: &[Bounds], items: &mut [u32], first: usize) {
        let merge = |(low, high): Bounds, (l, h): Bounds| (low.min(l), high.max(h));
        let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = items.iter().map(|&i| boxes[i as usize]).fold(nothing, merge);
        let at = self.nodes.len();
        let count = items.len();
        self.nodes.push(Node { low, high, first: first as u32, count: count as u32 });
        if count <= LEAF {
            return;
        }
        let twice_center = |i: u32| boxes[i as usize].0 + boxes[i as usize].1;
        let centers = items.iter().map(|&i| (twice_center(i), twice_center(i)));
        let (low, high) = centers.fold(nothing, merge);
        let axis = (high - low).max_position();
        items.select_nth_unstable_by(count / 2, |&a, &b| {
            twice_center(a)[axis].total_cmp(&twice_center(b)[axis]).then(a.cmp(&b))
        });
        let (left, right) = items.split_at_mut(count / 2);
        self.split(boxes, left, first);
        self.nodes[at].first = self.nodes.len() as u32;
        self.nodes[at].count = 0;
        self.split(boxes, right, first + count / 2);
    }

    /// The items, as leaves refer to them.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Parents before their children.
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Box of all.
    pub(crate) fn bounds(&self) -> Bounds {
        self.nodes.first().map_or((Vec3::ZERO, Vec3::ZERO), |node| (node.low, node.high))
    }

    /// The least of a squared distance over the items, each given by its place in the order;
    /// `most` where none is nearer.
    pub(crate) fn nearest(&self, point: Vec3, most: f32, mut item: impl FnMut(u32) -> f32) -> f32 {
        let mut nearest = most;
        let mut stack = [(0_u32, 0.0_f32); DEEPEST];
        let mut size = usize::from(!self.nodes.is_empty());
        while size > 0 {
            size -= 1;
            let (at, least) = stack[size];
            if least >= nearest {
                continue;
            }
            let node = &self.nodes[at as usize];
            if node.count > 0 {
                nearest = node.items().map(&mut item).fold(nearest, f32::min);
                continue;
            }
            let child = |at: u32| (at, self.nodes[at as usize].distance_squared(point));
            let (mut near, mut far) = (child(at + 1), child(node.first));
            if near.1 > far.1 {
                std::mem::swap(&mut near, &mut far);
            }
            stack[size] = far;
            stack[size + 1] = near;
            size += 2;
        }
        nearest
    }

    /// Walks down from the root: `enter` says of each node whether to go on below it, and `item`
    /// gets the items of the leaves that it enters. `item` ends the walk by returning true.
    pub(crate) fn walk(
        &self,
        mut enter: impl FnMut(u32, &Node) -> bool,
        mut item: impl FnMut(u32) -> bool,
    ) -> bool {
        let mut stack = [0_u32; DEEPEST];
        let mut size = usize::from(!self.nodes.is_empty());
        while size > 0 {
            size -= 1;
            let at = stack[size];
            let node = &self.nodes[at as usize];
            if !enter(at, node) {
                continue;
            }
            if node.count > 0 {
                if node.items().any(&mut item) {
                    return true;
                }
                continue;
            }
            stack[size] = node.first;
            stack[size + 1] = at + 1;
            size += 2;
        }
        false
    }

    /// Whether `hit` holds for an item whose box holds the point; `hit` gets places in the order.
    pub(crate) fn any_at(&self, point: Vec3, hit: impl FnMut(u32) -> bool) -> bool {
        let holds = |_, node: &Node| node.low.cmple(point).all() && node.high.cmpge(point).all();
        self.walk(holds, hit)
    }
}

"""Makes helicopter.obj, rotor.obj and funnel.obj beside this file: see LICENSES.md. Needs numpy."""
import os
HERE = os.path.dirname(os.path.abspath(__file__))
import numpy as np, math
class Obj:
    def __init__(s): s.v=[];s.n=[];s.f=[]
    def grid(s, fn, nu, nv, color, wrap=True):
        # fn(u,v) -> point; u in 0..1 around, v in 0..1 along; colour fn(p,u,v)
        base=len(s.v)
        e=1e-4
        for j in range(nv+1):
            for i in range(nu+1):
                u,v=i/nu,j/nv
                p=fn(u,v)
                du=fn(u+e,v)-fn(u-e,v); 
                v0,v1=max(v-e,0),min(v+e,1)
                dv=fn(u,v1)-fn(u,v0)
                n=np.cross(dv,du); l=np.linalg.norm(n)
                if l<1e-12:
                    vv=min(max(v,0.02),0.98)
                    n=np.cross(fn(u,vv+e)-fn(u,vv-e),fn(u+e,vv)-fn(u-e,vv)); 
                    # pole: along the axis
                    n=fn(0.0,v)-fn(0.0,0.5 if v<0.5 else 0.5); l=np.linalg.norm(n)
                s.v.append((p,color(p,u,v))); s.n.append(n/max(l,1e-12))
        w=nu+1
        for j in range(nv):
            for i in range(nu):
                a=base+j*w+i; b=a+1; c=a+w; d=c+1
                s.f.append((a,c,b)); s.f.append((b,c,d))
    def tube(s,a,b,ra,rb,color,nu=12,caps=True):
        a=np.array(a,float);b=np.array(b,float);d=(b-a)/np.linalg.norm(b-a)
        x=np.cross(d,[0,0,1.0] if abs(d[2])<0.9 else [1.0,0,0]); x/=np.linalg.norm(x); y=np.cross(d,x)
        def fn(u,v):
            t=2*math.pi*u
            if caps:
                # rounded ends
                vs=[0,0.08,0.92,1]
                if v<0.08: k=math.sin(v/0.08*math.pi/2); q=0; r=ra*k; off=-(1-k)*0
                elif v>0.92: k=math.sin((1-v)/0.08*math.pi/2); q=1; r=rb*k
                else: q=(v-0.08)/0.84; r=ra+(rb-ra)*q
            else: q=v; r=ra+(rb-ra)*q
            return a+(b-a)*q+r*(math.cos(t)*x+math.sin(t)*y)
        s.grid(fn,nu,8,lambda p,u,v:color)
    def slab(s,pts,color):
        # box by 8 corners: bottom 4, top 4, flat normals
        idx=[(0,1,2,3),(7,6,5,4),(0,4,5,1),(1,5,6,2),(2,6,7,3),(3,7,4,0)]
        pts=[np.array(p,float) for p in pts]
        c=sum(pts)/8
        for q in idx:
            p=[pts[k] for k in q]; n=np.cross(p[1]-p[0],p[2]-p[0]); n/=np.linalg.norm(n)
            m=sum(p)/4
            order=(0,1,2,3)
            if np.dot(n,m-c)<0: n=-n; order=(3,2,1,0)
            base=len(s.v)
            for k in order: s.v.append((p[k],color)); s.n.append(n)
            s.f.append((base,base+1,base+2)); s.f.append((base,base+2,base+3))
    def fix(s):
        # faces whose winding disagrees with their normals
        out=[]
        for a,b,c in s.f:
            pa,pb,pc=s.v[a][0],s.v[b][0],s.v[c][0]
            n=np.cross(pb-pa,pc-pa)
            if np.linalg.norm(n)<1e-10: continue
            m=s.n[a]+s.n[b]+s.n[c]
            out.append((a,b,c) if np.dot(n,m)>0 else (a,c,b))
        s.f=out
    def write(s,path,head):
        s.fix()
        with open(path,'w') as f:
            f.write(head)
            g=lambda x: ('%.3f'%x).rstrip('0').rstrip('.') if abs(x)>=5e-4 else '0'
            for p,c in s.v: f.write('v '+' '.join(g(x) for x in p)+' '+' '.join('%.3g'%x for x in c)+'\n')
            for n in s.n: f.write('vn '+' '.join('%.3g'%x for x in n)+'\n')
            for a,b,c in s.f: f.write(f'f {a+1}//{a+1} {b+1}//{b+1} {c+1}//{c+1}\n')
        print(path,len(s.v),len(s.f))
red=(0.42,0.03,0.02); white=(0.72,0.71,0.68); glass=(0.012,0.018,0.024); dark=(0.03,0.03,0.032); steel=(0.16,0.16,0.165); yellow=(0.65,0.42,0.03)
b=Obj()
# Nose towards -z; skids stand on y = 0. Fuselage: sections along z.
zs=np.array([-2.35,-2.2,-1.7,-1.0,-0.2,0.7,1.5,2.2,2.7]); 
hw=np.array([0.0,0.28,0.62,0.80,0.84,0.80,0.62,0.38,0.20])
top=np.array([1.05,1.30,1.72,2.05,2.15,2.12,2.00,1.86,1.76])
bot=np.array([1.05,0.88,0.62,0.52,0.50,0.55,0.80,1.18,1.44])
def smooth(xs,ys,x):
    # monotone-ish cubic (finite difference tangents)
    i=int(np.clip(np.searchsorted(xs,x)-1,0,len(xs)-2)); 
    h=xs[i+1]-xs[i]; t=(x-xs[i])/h
    def m(k):
        if k==0: return (ys[1]-ys[0])/(xs[1]-xs[0])
        if k==len(xs)-1: return (ys[-1]-ys[-2])/(xs[-1]-xs[-2])
        return (ys[k+1]-ys[k-1])/(xs[k+1]-xs[k-1])
    a,c=m(i)*h,m(i+1)*h
    return (2*t**3-3*t*t+1)*ys[i]+(t**3-2*t*t+t)*a+(-2*t**3+3*t*t)*ys[i+1]+(t**3-t*t)*c
def fus(u,v):
    z=zs[0]+(zs[-1]-zs[0])*(0.5-0.5*math.cos(math.pi*min(max(v*0.86,0),1)) )/(0.5-0.5*math.cos(math.pi*0.86))
    z=min(max(z,zs[0]),zs[-1])
    w,t,o=max(smooth(zs,hw,z),0),smooth(zs,top,z),smooth(zs,bot,z)
    if z<-2.2:
        k=math.sqrt(max((z+2.35)/0.15,0)); w=0.28*k; mid=1.09; t=mid+0.21*k; o=mid-0.21*k
    a=2*math.pi*u; c,s=math.cos(a),math.sin(a)
    e=0.80
    x=w*math.copysign(abs(c)**e,c); y=(t+o)/2+(t-o)/2*math.copysign(abs(s)**e,s)
    return np.array([x,y,z])
def paint(p,u,v):
    # By the grid's own lines, so that no edge is jagged
    x,y,z=p; h=math.sin(2*math.pi*u)
    if -2.16<z<-0.2 and 0.10<h<0.93: return white if abs(z+1.05)<0.07 and abs(x)>0.3 else glass
    if -2.26<z<=-2.16 and 0.25<h: return glass
    if -0.05<z<0.8 and 0.10<h<0.75: return glass
    return red if h<-0.2 else white
b.grid(fus,48,52,paint)
# Tail boom
b.tube((0,1.62,2.35),(0,1.98,6.3),0.24,0.10,white,16)
b.tube((0,1.75,3.9),(0,1.8,4.3),0.205,0.19,red,16,caps=False)
# Engine cowl and mast
def ell(c,r):
    c=np.array(c);r=np.array(r)
    return lambda u,v: c+r*np.array([math.sin(math.pi*v)*math.cos(2*math.pi*u),math.cos(math.pi*v),math.sin(math.pi*v)*math.sin(2*math.pi*u)])
b.grid(ell((0,2.2,0.45),(0.5,0.36,1.15)),32,16,lambda p,u,v: red if p[1]<2.42 else white)
b.tube((0,2.4,0.1),(0,3.02,0.1),0.075,0.06,steel,12)
b.tube((0.28,2.3,1.2),(0.34,2.34,1.75),0.1,0.1,dark,12)
b.tube((-0.28,2.3,1.2),(-0.34,2.34,1.75),0.1,0.1,dark,12)
# Fin and stabiliser
def fin(z0,z1,y0,y1,zt0,zt1,t):
    return [(-t,y0,z0),(t,y0,z0),(t,y0,z1),(-t,y0,z1),(-t*.6,y1,zt0),(t*.6,y1,zt0),(t*.6,y1,zt1),(-t*.6,y1,zt1)]
b.slab(fin(5.65,6.35,1.9,3.0,6.25,6.7,0.05),red)
b.slab(fin(5.8,6.3,1.95,1.35,6.15,6.45,0.05),red)
b.slab([(-1.0,1.84,4.9),(1.0,1.84,4.9),(1.0,1.84,5.35),(-1.0,1.84,5.35),(-1.0,1.9,4.95),(1.0,1.9,4.95),(1.0,1.9,5.3),(-1.0,1.9,5.3)],white)
# Tail rotor: two blades
for a in (0.6,0.6+math.pi):
    c,s=math.cos(a),math.sin(a)
    def P(r,w,x): return (0.16+x, 2.15+r*c-w*s, 6.35+r*s+w*c)
    b.slab([P(0.08,-0.06,-0.012),P(0.08,0.06,-0.012),P(0.72,0.07,-0.012),P(0.72,-0.07,-0.012),P(0.08,-0.06,0.012),P(0.08,0.06,0.012),P(0.72,0.07,0.012),P(0.72,-0.07,0.012)],dark)
b.tube((0.02,2.15,6.35),(0.2,2.15,6.35),0.06,0.05,steel,10)
# Skids
for side in (-1,1):
    x=side*1.02
    b.tube((x,0.06,-1.7),(x,0.06,1.7),0.055,0.055,dark,12)
    b.tube((x,0.06,-1.68),(x,0.34,-2.15),0.055,0.05,dark,12)
    for z in (-0.8,0.9):
        b.tube((side*0.35,0.72,z),(side*0.85,0.42,z),0.05,0.045,dark,10)
        b.tube((side*0.83,0.45,z),(x,0.06,z),0.045,0.045,dark,10)
b.write(HERE + '/helicopter.obj','# A light helicopter, nose towards -z, skids on y = 0, the hub at (0, 3.05, 0.1). CC0.\n')
r=Obj()
N=2; R=5.0
for k in range(N):
    a=2*math.pi*k/N
    c,s=math.cos(a),math.sin(a)
    def P(rr,w,y): return (rr*c - w*s, y, -(rr*s + w*c))
    segs=12
    for i in range(segs):
        r0,r1=0.45+(R-0.45)*i/segs,0.45+(R-0.45)*(i+1)/segs
        f=lambda rr: (0.16 if rr>0.9 else 0.10, 0.05-0.0+0.016*(rr/R)*rr*1.2, 0.05*(1-rr/R)+0.02)
        def C(rr):
            w,y,p=f(rr); return [P(rr,-w,y-p-0.012),P(rr,w,y+p-0.012),P(rr,w,y+p+0.012),P(rr,-w,y-p+0.012)]
        A,B=C(r0),C(r1)
        col=yellow if i==segs-1 else dark
        r.slab([A[0],A[1],B[1],B[0],A[3],A[2],B[2],B[3]],col)
    r.slab([P(0,-0.06,0.0),P(0,0.06,0.0),P(0.6,0.05,0.0),P(0.6,-0.05,0.0),P(0,-0.06,0.09),P(0,0.06,0.09),P(0.6,0.05,0.09),P(0.6,-0.05,0.09)],steel)
r.grid(ell((0,0.05,0),(0.2,0.16,0.2)),20,10,lambda p,u,v: steel)
r.write(HERE + '/rotor.obj','# Two rotor blades of 5 m round (0, 0, 0), turning about y. CC0.\n')

# The funnel of a tornado
rng=np.random.default_rng(4)
H=34.0
def fn(u,v):
    y=H*v
    # A narrow foot, a wide head; leaning and bent like a rope.
    r=0.55+0.9*math.exp(-((v-0.0)/0.04)**2)+6.0*v**2.2
    t=2*math.pi*u
    tw=9.0*v**0.8
    r*=1+0.10*math.sin(3*t+tw*1.6)+0.07*math.sin(5*t+2.3*tw+1)+0.04*math.sin(11*t+3.7*tw)+0.05*math.sin(2*t-31*v)
    cx=1.6*math.sin(2.6*v)+0.35*math.sin(11*v); cz=1.1*math.sin(3.6*v+0.6)-1.1*math.sin(0.6)
    return np.array([cx+r*math.cos(t),y-0.3,cz+r*math.sin(t)])
def col(p,u,v):
    dust=np.array([0.20,0.165,0.115]); cloud=np.array([0.33,0.34,0.35])
    t=2*math.pi*u; tw=9.0*v**0.8
    k=min(v*1.7,1)
    c=dust*(1-k)+cloud*k
    return tuple(c*(0.92+0.13*math.sin(3*t+tw*1.6)))
o=Obj(); o.grid(fn,48,72,col)
o.write(HERE + '/funnel.obj','# The funnel of a tornado, 34 m high, its foot at (0, 0, 0). CC0.\n')

/* carom. Contains three.js and uPlot, MIT; texts in src/client/LICENSES. */
"use strict";(()=>{var Tv=Object.defineProperty;var Av=(n,e)=>{for(var t in e)Tv(n,t,{get:e[t],enumerable:!0})};var Ys=[.05,.1,.25,.5,1,2,4,10];function Gn(){return{position:new Float64Array(3),velocity:new Float64Array(3),spin:new Float64Array(3)}}var kl=class{constructor(e,t,i,r){this.times=e;this.positions=t;this.velocities=i;this.spins=r}times;positions;velocities;spins;hint=0;get count(){return this.times.length}knotsUntil(e,t=!1){let{times:i}=this,r=l=>t?i[l]<e:i[l]<=e,s=this.hint;if((s===0||r(s-1))&&(s===i.length||!r(s)))return s;if(s<i.length&&r(s)&&(s+1===i.length||!r(s+1)))return this.hint=s+1;let o=0,a=i.length;for(;o<a;)s=o+a>>1,r(s)?o=s+1:a=s;return this.hint=o}at(e,t,i=!1){let{times:r}=this;if(r.length===0)return!1;let s=this.knotsUntil(e,i);return i&&s<r.length&&r[s]===e?this.copy(s,t):s===0||s===r.length?this.copy(s===0?0:s-1,t):this.between(s-1,e,t),!0}copy(e,t){for(let i=0;i<3;i+=1)t.position[i]=this.positions[3*e+i],t.velocity[i]=this.velocities[3*e+i],t.spin[i]=this.spins.length>0?this.spins[3*e+i]:0}between(e,t,i){let{times:r,positions:s,velocities:o,spins:a}=this,l=r[e+1]-r[e],c=(t-r[e])/l,[u,h]=[c*c,c*c*c],[f,p]=[3*e,3*e+3];for(let m=0;m<3;m+=1)i.position[m]=s[f+m]*(2*h-3*u+1)+o[f+m]*(l*(h-2*u+c))+s[p+m]*(3*u-2*h)+o[p+m]*(l*(h-u)),i.velocity[m]=o[f+m]+c*(o[p+m]-o[f+m]),i.spin[m]=a.length>0?a[f+m]+c*(a[p+m]-a[f+m]):0}};var Rv=.06,Cv=24;function zl(n,e){let t=[],i=Gn(),{times:r,positions:s,velocities:o}=n;for(let a=0;a<n.count&&r[a]<=e;a+=1){let[l,c]=[s[3*a],s[3*a+1]],u=t.length-3;!(u>=0&&t[u+1]===l&&t[u+2]===c)||a+1===n.count?t.push(r[a],l,c):t[u]=r[a];let f=a+1<n.count?r[a+1]-r[a]:0;if(f>0){let p=Pv(o,3*a,3*a+3),m=Math.min(Cv,Math.ceil(p/Rv));for(let M=1;M<m;M+=1){let d=r[a]+f*M/m;n.at(d,i),t.push(d,i.position[0],i.position[1])}}}return Float64Array.from(t)}function Pv(n,e,t){let i=n[e]*n[t+1]-n[e+1]*n[t],r=n[e]*n[t]+n[e+1]*n[t+1];return Math.abs(Math.atan2(i,r))}var pa=.45;function Gl(n,e){let t=new Map(n.data.balls.map((o,a)=>[o.id,a])),[i,r]=[Gn(),Gn()],s=[];for(let o of e.events){let a=t.get(o.a);if(a===void 0||!e.paths[a]?.at(o.at,i))continue;let[l,c,u]=[i.position[0],i.position[1],n.radii[a]],h=t.get(o.b);if(o.kind==="ball-ball"&&h!==void 0&&e.paths[h]?.at(o.at,r)){let f=u/(u+n.radii[h]);s.push({at:o.at,x:l+f*(r.position[0]-l),y:c+f*(r.position[1]-c),r:1.25*Math.max(u,n.radii[h])})}else if(o.kind==="ball-cushion"){let f={x0:[-u,0],x1:[u,0],y0:[0,-u],y1:[0,u]},[p,m]=f[o.b]??[0,0];s.push({at:o.at,x:l+p,y:c+m,r:.8*u})}else o.kind==="pocket"&&s.push({at:o.at,x:l,y:c,r:1.6*u})}return s}function $s(n,e){let t=e.every(l=>e.every(c=>l===c||Math.hypot(l.x-c.x,l.y-c.y)>l.r+c.r)),i=[[n.x0,n.y0],[n.x1,n.y0],[n.x1,n.y1],[n.x0,n.y1]],r=[],s=0,o=[];for(let l=0;l<4;l+=1){let[c,u]=i[l],[h,f]=i[(l+1)%4],p=Math.hypot(h-c,f-u),[m,M]=[(h-c)/p,(f-u)/p];o.push(s);for(let d of t?e:[]){let g=(d.x-c)*m+(d.y-u)*M,v=(d.x-c)*M-(d.y-u)*m;if(Math.abs(v)>=d.r)continue;let T=Math.sqrt(d.r*d.r-v*v);for(let y of[!0,!1]){let C=g+(y?-T:T);C>=0&&C<=p&&r.push({at:s+C,enters:y,pocket:d,x:c+C*m,y:u+C*M})}}s+=p}r.sort((l,c)=>l.at-c.at);let a=r.every((l,c)=>l.enters!==r[(c+1)%r.length].enters);return Lv(i,o,a&&r.length>1?r:[])}function Lv(n,e,t){let i={points:[],arcs:[],straights:[]},r=o=>({at:e[o],enters:!1,pocket:{x:0,y:0,r:0},x:n[o][0],y:n[o][1]});if(t.length===0){for(let o=0;o<4;o+=1)nh(i,r(o),r((o+1)%4),!1,!1);return i}let s=t.findIndex(o=>!o.enters);for(let o=0;o<t.length;o+=2){let a=t[(s+o)%t.length],l=t[(s+o+1)%t.length],c=e.map((d,g)=>({at:d,edge:g})).filter(({at:d})=>a.at<l.at?d>a.at&&d<l.at:d>a.at||d<l.at).sort((d,g)=>np(d.at,a.at)-np(g.at,a.at)),u=a,h=!0;for(let{edge:d}of c)nh(i,u,r(d),h,!1),u=r(d),h=!1;nh(i,u,l,h,!0);let f=t[(s+o+2)%t.length],{pocket:p}=l,m=Math.atan2(l.y-p.y,l.x-p.x),M=Math.atan2(f.y-p.y,f.x-p.x)-m;M+=M<=0?2*Math.PI:0,i.arcs.push({pocket:p,from:m,sweep:M});for(let d=0;d<28;d+=1){let g=m+M*d/28;i.points.push([p.x+p.r*Math.cos(g),p.y+p.r*Math.sin(g)])}}return i}function np(n,e){return n>e?n:n+1e12}function nh(n,e,t,i,r){n.points.push([e.x,e.y]),Math.hypot(t.x-e.x,t.y-e.y)>1e-9&&n.straights.push({x0:e.x,y0:e.y,x1:t.x,y1:t.y,pocketBefore:i,pocketAfter:r})}var Dv=["#f2b705","#1747b0","#d3202a","#4b2a86","#f26a1b","#0b6b3a","#7d1a22","#16181a"],rp=["#c8452f","#2f6fb0","#e0a526","#3d8f63","#8a5aa8","#d9793a","#4aa0a8","#b0567c","#7a8a2e","#5a6b7a"],Iv="#f6f1e4";function zr(n,e){if(/^(cue|white)$/i.test(n))return{colour:Iv,striped:!1,label:"",spotted:!0};let t=/^\d{1,2}$/.test(n)?Number(n):0;if(t>=1&&t<=15)return{colour:Dv[(t-1)%8],striped:t>8,label:String(t),spotted:!1};let i=[...n].length<=3?n:[...n].slice(0,3).join("");return{colour:rp[e%rp.length],striped:!1,label:i,spotted:!1}}var sp=[{light:"#0072b2",dark:"#4aa3e0",cloth:"#7cc8ff",dash:[],beats:0},{light:"#b84e00",dark:"#ff8a3c",cloth:"#ff9a4d",dash:[7,4],beats:8},{light:"#007a59",dark:"#2fc79a",cloth:"#9dffd8",dash:[2,3],beats:16},{light:"#a0437c",dark:"#e08ac0",cloth:"#ff9ddb",dash:[10,3,2,3],beats:5},{light:"#8a5f00",dark:"#edb93c",cloth:"#ffe066",dash:[14,5],beats:4},{light:"#1f7aa8",dark:"#9bd3f5",cloth:"#d5efff",dash:[5,2,1,2],beats:12},{light:"#1d2429",dark:"#e4e8eb",cloth:"#ffffff",dash:[1,2],beats:20}];function cn(n){return sp[n%sp.length]}function rh(n){return matchMedia("(prefers-color-scheme: dark)").matches?cn(n).dark:cn(n).light}var Hl="#12694f";function op(n,e){let[t,i]=n.origin,r=(d,g)=>[(d-t)/n.R,(g-i)/n.R],s=Float64Array.from(n.balls,d=>d.radius/n.R),o=n.pockets.map(([d,g,v])=>{let[T,y]=r(d,g);return{x:T,y,r:v/n.R}}),{moved:a,floor:l}=Fv(e,s),c=null;if(n.table){let[d,g]=r(...n.table.min),[v,T]=r(...n.table.max);c={x0:d,y0:g,x1:v,y1:T}}let u=Qi(a,Math.max(4,.12*Math.max(a.x1-a.x0,a.y1-a.y0))),h=c?Qi(c,1.25+2.9):u,f=Qi(a,6),p=[h,f].map(d=>Math.max(d.x1-d.x0,d.y1-d.y0)),m=p[0]>90&&p[0]>4*p[1],M=Math.max(0,...e.map(d=>d.facts.end));return{data:n,runs:e,table:c,pockets:o,cloth:c??u,sight:m?f:h,floor:l,radii:s,end:M}}function Qi(n,e){return{x0:n.x0-e,y0:n.y0-e,x1:n.x1+e,y1:n.y1+e}}function Fv(n,e){let t={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0},i=1/0;for(let r of n)r.paths.forEach((s,o)=>{let a=e[o];for(let l=0;l<s.positions.length;l+=3){let[c,u,h]=[s.positions[l],s.positions[l+1],s.positions[l+2]];Number.isFinite(c+u+h)&&(t.x0=Math.min(t.x0,c-a),t.y0=Math.min(t.y0,u-a),t.x1=Math.max(t.x1,c+a),t.y1=Math.max(t.y1,u+a),i=Math.min(i,h-a))}});return Number.isFinite(t.x1-t.x0+t.y1-t.y0)?{moved:t,floor:Number.isFinite(i)?i:0}:{moved:{x0:-10,y0:-10,x1:10,y1:10},floor:0}}function Vl(n,e){let[t,i]=[n.x1-n.x0,n.y1-n.y0],r=Math.min(t,i)/4,s=1.25+.55*2.9,o=[],[a,l]=[Math.min(64,Math.round(t/r)),Math.min(64,Math.round(i/r))];for(let c=1;c<a;c+=1)o.push([n.x0+t*c/a,n.y0-s],[n.x0+t*c/a,n.y1+s]);for(let c=1;c<l;c+=1)o.push([n.x0-s,n.y0+i*c/l],[n.x1+s,n.y0+i*c/l]);return o.filter(([c,u])=>e.pockets.every(h=>Math.hypot(h.x-c,h.y-u)>h.r+1.6))}function Gr(n){if(!n.apart)return[n.solid];let e=n.shown.flatMap((t,i)=>t||i===n.solid?[i]:[]);return e.length>0?e:[n.solid]}function Wl(n,e){return n.apart?[]:n.shown.flatMap((t,i)=>t&&i!==e?[i]:[])}function Xl(n,e){let[t,i]=[n.x1-n.x0,n.y1-n.y0];return{zoom:Math.min(1,Math.max((e.x1-e.x0)/t,(e.y1-e.y0)/i)),x:(e.x0+e.x1-n.x0-n.x1)/2,y:(e.y0+e.y1-n.y0-n.y1)/2}}function ps(n,e,t,i){let[r,s]=[n.x1-n.x0,n.y1-n.y0],o={columns:1,rows:e,lying:!0,scale:0};for(let u=1;u<=e;u+=1){let h=Math.ceil(e/u);for(let f of[!0,!1]){let[p,m]=f?[s,r]:[r,s],M=Math.min(t/u/p,i/h/m);M>o.scale&&(o={columns:u,rows:h,lying:f,scale:M})}}let[a,l]=[t/o.columns,i/o.rows];return{cells:Array.from({length:e},(u,h)=>({x:h%o.columns*a,y:Math.floor(h/o.columns)*l,width:a,height:l})),lying:o.lying}}function ql(n,e,t){return n.findIndex(i=>e>=i.x&&e<i.x+i.width&&t>=i.y&&t<i.y+i.height)}var ap=.03,Uv=.4;function Yl(n,e,t){let i=Math.hypot(n[3*t]-e[3*t],n[3*t+1]-e[3*t+1],n[3*t+2]-e[3*t+2]),r=Math.min(1,Math.max(0,(i-ap)/(Uv-ap)));return r*r*(3-2*r)}var Hr=class{constructor(e,t){this.stage=e;this.still=t;let i=this.canvas.getContext("2d");if(!i)throw new Error("this browser has no canvas");this.pen=i}stage;still;canvas=document.createElement("canvas");pen;marksOf=new Map;lines=new Map;width=1;height=1;ratio=1;closer=1;middle=[0,0];shift=[0,0];drawn=null;look(){this.close(null)}close(e){let{zoom:t,x:i,y:r}=e?Xl(this.stage.sight,e):{zoom:1,x:0,y:0};this.closer=1/t,this.middle=[i,r],this.shift=[0,0]}orbit(e,t){this.pan(-e,t)}zoom(e){this.closer=Math.min(25,Math.max(.5,this.closer/e))}pan(e,t){this.shift[0]-=e*this.height,this.shift[1]+=t*this.height}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=Math.min(2,window.devicePixelRatio||1),this.canvas.width=Math.round(this.width*this.ratio),this.canvas.height=Math.round(this.height*this.ratio)}draw(e,t,i){this.drawn={frame:e,choice:t};let{pen:r,ratio:s}=this;r.setTransform(s,0,0,s,0,0),r.clearRect(0,0,this.width,this.height);let o=Gr(t),{cells:a,lying:l}=ps(this.stage.sight,o.length,this.width,this.height);return o.forEach((c,u)=>{let h=a[u];r.save(),r.beginPath(),r.rect(h.x,h.y,h.width,h.height),r.clip(),this.one(e,t,c,i,this.lens(h,l)),r.restore()}),!1}pick(e,t){if(!this.drawn)return-1;let{frame:i,choice:r}=this.drawn,s=Gr(r),{cells:o,lying:a}=ps(this.stage.sight,s.length,this.width,this.height),l=ql(o,e,t);if(l<0)return-1;let c=this.lens(o[l],a),u=i.scatters[s[l]],h={ball:-1,distance:18};for(let f=0;f<u.present.length;f+=1){let[p,m]=yr(c,u.positions[3*f],u.positions[3*f+1]),M=Math.hypot(p-e,m-t);u.present[f]&&M<h.distance&&(h={ball:f,distance:M})}return h.ball}dispose(){this.canvas.remove()}lens(e,t){let{sight:i}=this.stage,[r,s]=[i.x1-i.x0,i.y1-i.y0];return{scale:.96*this.closer*Math.min(e.width/(t?s:r),e.height/(t?r:s)),lying:t,px:e.x+e.width/2+this.shift[0],py:e.y+e.height/2+this.shift[1],cx:(i.x0+i.x1)/2+this.middle[0],cy:(i.y0+i.y1)/2+this.middle[1]}}one(e,t,i,r,s){let o=e.scatters[i],a=Wl(t,i);this.table(s),t.trails&&(a.forEach(l=>this.trails(l,e.time,!0,s)),this.trails(i,e.time,!1,s)),t.marks&&this.rings(i,e.time,pa*r,s),this.ring(s,o,t.ball,1.2,.1,"rgba(255,255,255,.8)");for(let l=0;l<this.stage.radii.length;l+=1)o.present[l]&&this.ball(s,o,l);a.forEach(l=>this.ghosts(s,e.scatters[l],o,l));for(let l of t.called)this.ring(s,o,l,1.11,.18,"#ffe98a")}table(e){let{pen:t,stage:i}=this,r=(o,a)=>{t.beginPath();for(let[l,c]of o)t.lineTo(...yr(e,l,c));t.closePath(),t.fillStyle=a,t.fill()},s=o=>[[o.x0,o.y0],[o.x1,o.y0],[o.x1,o.y1],[o.x0,o.y1]];if(i.table){r(lp(Qi(i.table,1.25+2.9),2.4),"#6b3a20"),r(lp(Qi(i.table,1.25+2.9-.3),2.1),"#5a2f19"),r($s(Qi(i.table,1.25),i.pockets).points,"#0d5f46");for(let[o,a]of Vl(i.table,i))this.disc(e,o,a,.24,"#efe6d2")}r(s(i.cloth),Hl);for(let{x:o,y:a,r:l}of i.pockets)this.disc(e,o,a,l,"#0a0908")}disc(e,t,i,r,s){let{pen:o}=this;o.beginPath(),o.arc(...yr(e,t,i),Math.max(.5,r*e.scale),0,2*Math.PI),o.fillStyle=s,o.fill()}ball(e,t,i){let{pen:r,stage:s}=this,{colour:o,striped:a,label:l,spotted:c}=zr(s.data.balls[i].id,i),[u,h]=[t.positions[3*i],t.positions[3*i+1]],[f,p]=yr(e,u,h),m=Math.max(1.5,s.radii[i]*e.scale);this.disc(e,u+.12,h-.12,s.radii[i],"rgba(0,0,0,.3)"),r.save(),r.beginPath(),r.arc(f,p,m,0,2*Math.PI),r.fillStyle=a?"#f4efe2":o,r.fill(),r.clip(),a&&(r.fillStyle=o,r.fillRect(f-m,p-.55*m,2*m,1.1*m)),c&&(r.fillStyle="#c4202b",r.beginPath(),r.arc(f,p,.16*m,0,2*Math.PI),r.fill()),r.restore(),l&&m>5&&(r.fillStyle="#f4efe2",r.beginPath(),r.arc(f,p,.5*m,0,2*Math.PI),r.fill(),r.fillStyle="#16181a",r.font=`700 ${Math.round((l.length>2?.42:l.length>1?.58:.75)*m)}px Arial, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.fillText(l,f,p+.03*m))}ghosts(e,t,i,r){let{pen:s,stage:o}=this,{cloth:a,dash:l}=cn(r);for(let c=0;c<o.radii.length;c+=1){let u=t.present[c]?i.present[c]?Yl(t.positions,i.positions,c):1:0;u<=0||(s.globalAlpha=u,s.beginPath(),s.arc(...yr(e,t.positions[3*c],t.positions[3*c+1]),Math.max(1.5,o.radii[c]*e.scale),0,2*Math.PI),s.fillStyle=`${a}44`,s.fill(),s.strokeStyle=a,s.lineWidth=2,s.setLineDash(l.map(h=>h*.6)),s.stroke())}s.globalAlpha=1,s.setLineDash([])}ring(e,t,i,r,s,o){if(i<0||!t.present[i])return;let{pen:a}=this;a.beginPath(),a.arc(...yr(e,t.positions[3*i],t.positions[3*i+1]),r*this.stage.radii[i]*e.scale,0,2*Math.PI),a.strokeStyle=o,a.lineWidth=Math.max(1.2,s*e.scale),a.stroke()}rings(e,t,i,r){let{pen:s}=this,o=this.marksOf.get(e);o||(o=Gl(this.stage,this.stage.runs[e]),this.marksOf.set(e,o));for(let a of o){let l=(t-a.at)/i;l<0||l>1||(s.beginPath(),s.arc(...yr(r,a.x,a.y),a.r*r.scale*(this.still()?1:1+.9*l),0,2*Math.PI),s.strokeStyle=`rgba(255,247,217,${.9*(1-l)})`,s.lineWidth=2,s.stroke())}}trails(e,t,i,r){let{pen:s,stage:o}=this,a=this.lines.get(e);a||(a=o.runs[e].paths.map((l,c)=>zl(l,o.runs[e].leaves[c])),this.lines.set(e,a)),s.lineWidth=1.5,s.globalAlpha=.7,s.setLineDash(i?[5,4]:[]),a.forEach((l,c)=>{s.strokeStyle=i?cn(e).cloth:zr(o.data.balls[c].id,c).colour,s.beginPath();for(let u=0;u<l.length&&l[u]<=t;u+=3)if(s.lineTo(...yr(r,l[u+1],l[u+2])),u+3<l.length&&l[u+3]>t){let h=(t-l[u])/(l[u+3]-l[u]);s.lineTo(...yr(r,l[u+1]+h*(l[u+4]-l[u+1]),l[u+2]+h*(l[u+5]-l[u+2])))}s.stroke()}),s.globalAlpha=1,s.setLineDash([])}};function lp(n,e){return[[n.x1-e,n.y1-e,0],[n.x0+e,n.y1-e,1],[n.x0+e,n.y0+e,2],[n.x1-e,n.y0+e,3]].flatMap(([i,r,s])=>Array.from({length:9},(o,a)=>{let l=(s+a/8)*Math.PI/2;return[i+e*Math.cos(l),r+e*Math.sin(l)]}))}function yr(n,e,t){let[i,r]=[(e-n.cx)*n.scale,(t-n.cy)*n.scale];return n.lying?[n.px+r,n.py+i]:[n.px+i,n.py-r]}var $l=class{constructor(e){this.end=e;this.base=e>=.5&&e<=120?1:e/10||1}end;shown=0;running=!1;factor=1;last=0;request=0;listeners=new Set;base;get time(){return this.shown}get playing(){return this.running}get rate(){return this.factor}set rate(e){this.factor=e,this.tell()}listen(e){this.listeners.add(e)}seek(e){this.shown=Math.min(this.end,Math.max(0,Number.isFinite(e)?e:0)),this.tell()}play(){this.running||(this.shown>=this.end&&(this.shown=0),this.running=!0,this.last=performance.now(),this.request=requestAnimationFrame(this.step),this.tell())}pause(){cancelAnimationFrame(this.request),this.running&&(this.running=!1,this.tell())}stop(){this.listeners.clear(),this.pause()}step=e=>{let t=Math.min(.25,Math.max(0,(e-this.last)/1e3));this.last=e,this.shown=Math.min(this.end,this.shown+t*this.factor*this.base),this.running=this.shown<this.end,this.running&&(this.request=requestAnimationFrame(this.step)),this.tell()};tell(){for(let e of this.listeners)e(this)}};function he(n,e={},...t){let i=document.createElement(n);return cp(i,e),i.append(...t),i}var Nv="http://www.w3.org/2000/svg";function lr(n,e={},...t){let i=document.createElementNS(Nv,n);return cp(i,e),i.append(...t),i}function Kl(n){return lr("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},lr("path",{d:n}))}function Sr(n,e,t){let i=he("button",{type:"button","aria-label":n,title:n},...e);return i.addEventListener("click",t),i}function cp(n,e){for(let[t,i]of Object.entries(e))i!==void 0&&i!==!1&&n.setAttribute(t,i===!0?"":String(i))}function en(n,e){n.textContent!==e&&(n.textContent=e)}function sh(n,e=5){return n>0&&Number.isFinite(n)?Math.min(15,Math.max(0,e-Math.ceil(Math.log10(n)))):3}function ds(n,e=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let t=Math.abs(n);if(t>=1e6||t<.001)return n.toExponential(e-2).replace(/\.?0*e\+?/,"e");let i=n.toPrecision(e);return i.includes("e")?String(Number(i)):i.replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"")}function Oi(n,e){return n.toFixed(sh(e))}var Ov=7,Bv=10;async function up(n,e){let t=n.counts.reduce((f,p)=>f+p,0),i=e.rotates?Bv:Ov,r=await zv(kv(n.bytes));if(r.length!==t*i*4)throw new Error(`the knots hold ${r.length} bytes where ${t} knots of ${i} columns need ${t*i*4}`);let s=e.scene.speed_scale/e.R,o=(f,p)=>Gv(r,f*t,t,p),a=o(0,1),l=[1,2,3].map(f=>o(f,1)),c=[4,5,6].map(f=>o(f,s)),u=e.rotates?[7,8,9].map(f=>o(f,s)):[],h=0;return n.counts.map(f=>{let p=h+f,m=d=>d.subarray(h,p),M=new kl(m(a),oh(l.map(m)),oh(c.map(m)),oh(u.map(m)));return h=p,M})}function kv(n){let e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i+=1)t[i]=e.charCodeAt(i);return t}async function zv(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate-raw"));return new Uint8Array(await new Response(e).arrayBuffer())}function Gv(n,e,t,i){let r=h=>e*4+h*t,[s,o,a,l]=[r(0),r(1),r(2),r(3)],c=new DataView(new ArrayBuffer(4)),u=new Float64Array(t);for(let h=0;h<t;h+=1){let f=n[l+h]<<24|n[a+h]<<16|n[o+h]<<8|n[s+h];c.setInt32(0,f),u[h]=c.getFloat32(0)*i}return u}function oh(n){let[e,t,i]=n;if(!e)return new Float64Array(0);let r=new Float64Array(3*e.length);for(let s=0;s<e.length;s+=1)r[3*s]=e[s],r[3*s+1]=t[s],r[3*s+2]=i[s];return r}function Hv(n,e,t,i){let r=Math.hypot(e,t,i),s=r>1e-8?Math.sin(r/2)/r:.5,[o,a,l,c]=[s*e,s*t,s*i,Math.cos(r/2)],[u,h,f,p]=n;n[0]=c*u+o*p+a*f-l*h,n[1]=c*h-o*f+a*p+l*u,n[2]=c*f+o*h-a*u+l*p,n[3]=c*p-o*u-a*h-l*f;let m=Math.hypot(n[0],n[1],n[2],n[3]);for(let M=0;M<4;M+=1)n[M]/=m}function hp(n,e,t,i,r,s,o){let a=(d,g)=>e[t+d]+g*(e[i+d]-e[t+d]),[l,c,u]=[a(0,s),a(1,s),a(2,s)],[h,f,p]=[a(0,o),a(1,o),a(2,o)],m=r*(o-s),M=m*m/12;Hv(n,m*(l+h)/2+M*(f*u-p*c),m*(c+f)/2+M*(p*l-h*u),m*(u+p)/2+M*(h*c-f*l))}var Zl=class{constructor(e){this.path=e;let{times:t,spins:i,count:r}=e,s=new Float64Array([0,0,0,1]);for(let o=0;o<r;o+=1){this.push(t[o],o,0,s);let a=o+1<r?t[o+1]-t[o]:0;if(a>0&&i.length>0){let[l,c]=[3*o,3*o+3],u=Vv(i,l,c,a);for(let h=1;h<=u;h+=1)hp(s,i,l,c,a,(h-1)/u,h/u),h<u&&this.push(t[o]+a*h/u,o,h/u,s)}}}path;times=[];nodes=[];knots=[];parts=[];hint=0;at(e,t){let{times:i,nodes:r,path:s}=this;if(i.length-1<0||s.spins.length===0){t.set([0,0,0,1]);return}let a=this.find(e);for(let c=0;c<4;c+=1)t[c]=r[4*a+c];let l=this.knots[a];if(e>i[a]&&l+1<s.count){let c=s.times[l+1]-s.times[l],u=Math.min(1,(e-s.times[l])/c);hp(t,s.spins,3*l,3*l+3,c,this.parts[a],u)}}push(e,t,i,r){this.times.push(e),this.knots.push(t),this.parts.push(i),this.nodes.push(r[0],r[1],r[2],r[3])}find(e){let{times:t}=this,i=this.hint;if(t[i]<=e&&(i+1===t.length||t[i+1]>e))return i;let r=0,s=t.length;for(;r<s;){let o=r+s>>1;t[o]<=e?r=o+1:s=o}return this.hint=Math.max(0,r-1)}};function Vv(n,e,t,i){let[r,s,o,a,l,c]=[n[e],n[e+1],n[e+2],n[t],n[t+1],n[t+2]],u=Math.hypot(l*o-c*s,c*r-a*o,a*s-l*r),[h,f]=[Math.hypot(r,s,o),Math.hypot(a,l,c)];return u<=1e-9*h*f?1:Math.min(4096,Math.max(1,Math.ceil(i*Math.max(h,f)/.5)))}async function fp(n){let e=new Map(n.balls.map((t,i)=>[t.id,i]));return Promise.all(n.runs.map(async(t,i)=>{let r=await up(t.knots,n),s=new Float64Array(n.balls.length).fill(1/0),o=t.events.map(([l,c,u,h])=>({at:Math.fround(l),time:l,kind:c,a:u,b:h}));for(let l of o){let c=e.get(l.a);l.kind==="pocket"&&c!==void 0&&(s[c]=l.at)}let a=n.rotates?r.map(l=>new Zl(l)):[];return{facts:t,index:i,paths:r,turnings:a,events:o,leaves:s}}))}function Jl(n){switch(n.kind){case"ball-ball":return`${n.a} hits ${n.b}`;case"ball-cushion":return`${n.a} meets cushion ${n.b}`;case"stop":return`${n.a} stops`;case"slide-to-roll":return`${n.a} starts to roll`;case"spin-end":return`${n.a} stops spinning`;case"contact-begin":return`${n.a} and ${n.b} stay in contact`;case"contact-end":return`${n.a} and ${n.b} are no longer in contact`;case"pocket":return`${n.a} falls in pocket ${n.b.replace(/^p/,"")}`;default:return[n.kind,n.a,n.b].filter(Boolean).join(" ")}}function ma(n,e){let t=0,i=n.length;for(;t<i;){let r=t+i>>1;n[r].at<=e?t=r+1:i=r}return t}var pp="M8 5v14l11-7z",Wv="M6 5h4v14H6zM14 5h4v14h-4z",Xv="M6 6l8.5 6L6 18zM16 6h2v12h-2z",qv="M18 6l-8.5 6L18 18zM6 6h2v12H6z",Yv="M11 21v-7L5.6 8.6 4 10V4h6L8.4 5.6 12 9.2l3.6-3.6L14 4h6v6l-1.6-1.4L13 14v7z",Ql=class{constructor(e,t,i,r){this.stage=e;this.clock=t;let s=e.data.scene.time_unit;this.shape=lr("path",{d:pp}),this.play=Sr("Play",[lr("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},this.shape)],()=>i.toggle()),this.play.classList.add("rp-play"),this.rates=he("select",{"aria-label":"Speed",title:t.base===1?`1x: one ${s} in one second`:"1x: the longest run in ten seconds"}),this.rates.append(...Ys.map(h=>he("option",{value:h,selected:h===1},`${h}×`))),this.rates.addEventListener("change",()=>i.rate(Number(this.rates.value))),this.scrubber=he("input",{type:"range",min:0,max:e.end||1,step:"any",value:0,class:"rp-scrub","aria-label":"Time"}),this.scrubber.addEventListener("input",()=>i.seek(Number(this.scrubber.value)));let o=he("div",{class:"rp-transport",role:"group","aria-label":"Playback"},Sr("Event before",[Kl(qv)],()=>i.event(-1)),this.play,Sr("Next event",[Kl(Xv)],()=>i.event(1))),a=he("div",{class:"rp-row"},o,he("span",{class:"rp-clock"},this.now,he("span",{class:"rp-end"},` / ${Oi(e.end,e.end)} ${s}`)),this.rates);if(e.data.partings.length>0){let h=e.data.partings[0].time;this.jump=Sr("Jump to the first divergence",[Kl(Yv),he("span",{},"First divergence"),he("span",{class:"rp-at"},`${Oi(h,e.end)} ${s}`)],()=>i.parting()),this.jump.classList.add("rp-jump"),a.append(this.jump)}else e.runs.length>1&&a.append(he("span",{class:"rp-none"},"No collision order differs"));a.append(this.last);let l=he("div",{class:"rp-views",role:"group","aria-label":"Camera"}),c=r?[["above","From above"],["free","Free"],["flat","Flat"]]:[["flat","Flat"]];for(let[h,f]of c){let p=he("button",{type:"button","aria-pressed":"false"},f);p.addEventListener("click",()=>i.look(h)),this.cameras.set(h,p),l.append(p)}this.boxes={apart:e.runs.length>1?this.box("Side by side",h=>i.apart(h)):null,trails:this.box("Trails",h=>i.trails(h)),marks:this.box("Hits",h=>i.marks(h))};let u=he("div",{class:"rp-row rp-looks"},l);for(let h of[this.boxes.apart,this.boxes.trails,this.boxes.marks])h?.parentElement&&u.append(h.parentElement);this.element=he("div",{class:"rp-controls"},he("div",{class:"rp-time"},this.scrubber,this.ticks),a,u)}stage;clock;element;scrubber;play;shape;now=he("span",{class:"rp-now"});last=he("span",{class:"rp-event"});rates;jump=null;ticks=lr("svg",{class:"rp-ticks",viewBox:"0 0 1000 12",preserveAspectRatio:"none","aria-hidden":"true"});cameras=new Map;boxes;spoken=-1/0;tell(e){let{clock:t,stage:i}=this,r=Oi(t.time,i.end);en(this.now,r),this.scrubber.value=String(t.time),this.scrubber.style.setProperty("--rp-part",String(i.end>0?t.time/i.end:0));let s=ma(e,t.time),o=s>0?`event ${s} of ${e.length}: ${Jl(e[s-1])}`:`before the first of ${e.length} events`,a=e.length>0?o:"no events";en(this.last,a);let l=performance.now();(!t.playing||l-this.spoken>1e3)&&(this.spoken=l,this.scrubber.setAttribute("aria-valuetext",`${r} ${i.data.scene.time_unit}, ${a}`));let c=t.playing?"Pause":"Play";this.play.title!==c&&(this.play.title=c,this.play.setAttribute("aria-label",c),this.shape.setAttribute("d",t.playing?Wv:pp)),this.rates.value=String(t.rate)}choose(e){for(let[t,i]of this.cameras)i.setAttribute("aria-pressed",String(t===e.camera));this.boxes.apart&&(this.boxes.apart.checked=e.apart),this.boxes.trails.checked=e.trails,this.boxes.marks.checked=e.marks}mark(e){let{data:t,end:i}=this.stage,r=u=>(1e3*u/(i||1)).toFixed(2),s={"ball-ball":9,"ball-cushion":6,pocket:9,stop:3},o=(u,h)=>lr("path",{d:h,class:`rp-tick ${u}`,"vector-effect":"non-scaling-stroke"}),a=Object.entries(s).map(([u,h])=>{let f=e.filter(p=>p.kind===u).map(p=>`M${r(p.at)} 0v${h}`);return o(`rp-${u}`,f.join(""))}),l=t.partings.map(u=>o("rp-part",`M${r(u.time)} 0v12`)),c=t.horizon===null?[]:[o("rp-horizon",`M${r(t.horizon)} 0v12`)];this.ticks.replaceChildren(...a,...c,...l)}box(e,t){let i=he("input",{type:"checkbox"});return i.addEventListener("change",()=>t(i.checked)),he("label",{class:"rp-check"},i,e),i}};var jl=class{constructor(e){this.stage=e;let t=e.data.balls.length;this.scatters=e.runs.map(i=>({run:i,positions:new Float64Array(3*t),velocities:new Float64Array(3*t),spins:new Float64Array(3*t),orientations:new Float64Array(4*t).map((r,s)=>s%4===3?1:0),present:new Uint8Array(t)}))}stage;time=0;scatters;motion=Gn();quaternion=new Float64Array(4);go(e){this.time=e;let{motion:t,quaternion:i,stage:r}=this;for(let s of this.scatters){let{run:o}=s;for(let a=0;a<r.radii.length;a+=1){let l=o.paths[a],c=l!==void 0&&l.at(e,t);s.present[a]=c&&e<o.leaves[a]?1:0,c&&(s.positions.set(t.position,3*a),s.velocities.set(t.velocity,3*a),s.spins.set(t.spin,3*a)),r.data.rotates&&c&&(o.turnings[a].at(e,i),s.orientations.set(i,4*a))}}}};function dp(n,e){let t=new Map,i=0,r=0;n.addEventListener("pointerdown",o=>{t.set(o.pointerId,{x:o.clientX,y:o.clientY}),i=t.size===1?0:5,r=0,n.setPointerCapture(o.pointerId)}),n.addEventListener("pointermove",o=>{let a=t.get(o.pointerId),l=e.view();if(!a||!l)return;let[c,u]=[o.clientX-a.x,o.clientY-a.y];i+=Math.hypot(c,u),t.set(o.pointerId,{x:o.clientX,y:o.clientY});let{width:h,height:f}=n.getBoundingClientRect();if(t.size===1)o.shiftKey||(o.buttons&2)!==0?l.pan(-c/f,u/f):l.orbit(c/h,u/f);else{let[p,m]=[...t.values()],M=Math.hypot(p.x-m.x,p.y-m.y);r>0&&M>0&&l.zoom(r/M),r=M,l.pan(-c/2/f,u/2/f)}e.again()});let s=o=>{if(t.delete(o.pointerId)&&i<5&&o.type==="pointerup"){let a=n.getBoundingClientRect();e.choose(e.view()?.pick(o.clientX-a.left,o.clientY-a.top)??-1)}r=0};n.addEventListener("pointerup",s),n.addEventListener("pointercancel",s),n.addEventListener("contextmenu",o=>o.preventDefault()),n.addEventListener("wheel",o=>{(o.ctrlKey||document.activeElement===n)&&(o.preventDefault(),e.view()?.zoom(Math.exp(.0015*o.deltaY)),e.again())},{passive:!1})}var $v=[[["Space"],"play, pause"],[["←","→"],"back and on by a hundredth of the shot; with Alt by a thousandth"],[[",","."],"event before, next event"],[["d"],"first divergence, then the next"],[["Home","End"],"start, end"],[["[","]"],"slower, faster"],[["v"],"next camera"],[["t"],"trails"],[["Shift + arrows"],"turn and tilt the camera"],[["+","−","0"],"closer, farther, the whole table"],[["?"],"this list"]];function mp(){let n=$v.map(([e,t])=>he("div",{},he("dt",{},...e.map(i=>he("kbd",{},i))),he("dd",{},t)));return he("details",{class:"rp-keys"},he("summary",{},"Keys"),he("dl",{},...n))}function gp(n,e){n.addEventListener("keydown",t=>{!t.ctrlKey&&!t.metaKey&&Kv(t,e)&&t.preventDefault()})}function Kv(n,e){let{actions:t}=e,i=n.target,r=i.closest("select, button, summary, input:not([type=range])");if(r&&(r.matches("select")||n.key===" "||n.key==="Enter"||n.key.startsWith("Arrow")&&r.matches("input")))return!1;let o={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key];if(o&&n.shiftKey)return e.view()?.orbit(.04*o[0],.04*o[1]),e.again(),!0;if(o&&(o[0]!==0||i.matches("input[type=range]")))return t.nudge((o[0]-o[1])*(n.altKey?.001:.01)),!0;let l={" ":()=>t.toggle(),".":()=>t.event(1),",":()=>t.event(-1),d:()=>t.parting(),Home:()=>t.seek(0),End:()=>t.seek(e.end()),PageUp:()=>t.nudge(.1),PageDown:()=>t.nudge(-.1),"[":()=>t.faster(-1),"]":()=>t.faster(1),v:()=>e.nextCamera(),t:()=>e.toggleTrails(),"+":()=>ec(e,.85),"=":()=>ec(e,.85),"-":()=>ec(e,1/.85),0:()=>ec(e,0),"?":()=>{e.keys.open=!e.keys.open}}[n.key];return l?.(),l!==void 0}function ec(n,e){e===0?n.actions.look(n.camera()):(n.view()?.zoom(e),n.again())}var tc=class{element;shown=[];solid=[];rows=[];constructor(e,t){this.element=he("fieldset",{class:"rp-legend"},he("legend",{},"Engines"));let i=`rp-solid-${Math.random().toString(36).slice(2)}`,r=e.data.scene.time_unit;for(let{facts:s,index:o}of e.runs){let a=he("input",{type:"checkbox","aria-label":`Show ${s.label}`});a.addEventListener("change",()=>t.show(o,a.checked));let l=he("input",{type:"radio",name:i,"aria-label":`Balls of ${s.label} solid`});l.addEventListener("change",()=>t.solid(o)),this.shown.push(a),this.solid.push(l);let c=he("span",{class:"rp-name"},s.label,...s.reference?[he("small",{},"reference")]:[]),u=he("span",{class:"rp-ending"},Zv(s,`${Oi(s.end,e.end)} ${r}`)),h=he("div",{class:"rp-run"},he("label",{class:"rp-show"},a,Ks(o),c));e.runs.length>1&&h.append(he("label",{class:"rp-solid"},l,"solid")),h.append(u),e.data.partings.forEach((f,p)=>{if(f.runs[0]===o){let m=e.runs[f.runs[1]]?.facts.label??"",M=he("button",{type:"button",class:"rp-parts",title:f.words},`parts from ${m} at ${Oi(f.time,e.end)} ${r}`);M.addEventListener("click",()=>t.parting(p)),h.append(M)}}),this.rows.push(h),this.element.append(h)}}choose(e){this.shown.forEach((t,i)=>{t.checked=e.shown[i]||i===e.solid,t.disabled=i===e.solid,this.solid[i].checked=i===e.solid,this.rows[i].classList.toggle("rp-off",!t.checked)})}};function Zv(n,e){let t=n.ending.startsWith(`${n.engine}: `)?n.ending.slice(n.engine.length+2):n.ending;return/\d/.test(t)?t:`${t}, ${e}`}function Ks(n){let e=lr("line",{x1:0,y1:5,x2:34,y2:5,class:`rp-ink${n%7}`,"stroke-width":2.5,"stroke-dasharray":cn(n).dash.join(" ")||"none"});return lr("svg",{viewBox:"0 0 34 10",class:"rp-swatch","aria-hidden":"true"},e)}var Jv="uplot",Qv="u-hz",jv="u-vt",eM="u-title",tM="u-wrap",iM="u-under",nM="u-over",rM="u-axis",xs="u-off",sM="u-select",oM="u-cursor-x",aM="u-cursor-y",lM="u-cursor-pt",cM="u-legend",uM="u-live",hM="u-inline",fM="u-series",pM="u-marker",xp="u-label",dM="u-value",xa="width",_a="height";var _p="bottom",Zs="left",ah="right",wh="#000",vp=wh+"0",lh="mousemove",Mp="mousedown",ch="mouseup",yp="mouseenter",Sp="mouseleave",bp="dblclick",mM="resize",gM="scroll",wp="change",oc="dppxchange",Eh="--",no=typeof window<"u",dh=no?document:null,Qs=no?window:null,xM=no?navigator:null,Ut,ic;function mh(){let n=devicePixelRatio;Ut!=n&&(Ut=n,ic&&xh(wp,ic,mh),ic=matchMedia(`(min-resolution: ${Ut-.001}dppx) and (max-resolution: ${Ut+.001}dppx)`),_s(wp,ic,mh),Qs.dispatchEvent(new CustomEvent(oc)))}function hn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function gh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Hn(n,e,t,i){let r=dh.createElement(n);return e!=null&&hn(r,e),t?.insertBefore(r,i),r}function Tn(n,e){return Hn("div",n,e)}var Ep=new WeakMap;function cr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Ep.get(n);s!=o&&(n.style.transform=s,Ep.set(n,s),e<0||t<0||e>i||t>r?hn(n,xs):gh(n,xs))}var Tp=new WeakMap;function Ap(n,e,t){let i=e+t,r=Tp.get(n);i!=r&&(Tp.set(n,i),n.style.background=e,n.style.borderColor=t)}var Rp=new WeakMap;function Cp(n,e,t,i){let r=e+""+t,s=Rp.get(n);r!=s&&(Rp.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Th={passive:!0},_M={...Th,capture:!0};function _s(n,e,t,i){e.addEventListener(n,t,i?_M:Th)}function xh(n,e,t,i){e.removeEventListener(n,t,Th)}no&&mh();function Vn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:fn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function nd(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var rd=n=>n!=null,sd=n=>n!=null&&n>0,cc=nd(rd),vM=nd(sd);function MM(n,e,t,i=0,r=!1){let s=r?vM:cc,o=r?sd:rd;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function uc(n,e,t,i){let r=Dp(n),s=Dp(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?br:od,a=r==1?fn:An,l=s==1?An:fn,c=a(o(yi(n))),u=l(o(yi(e))),h=js(t,c),f=js(t,u);return t==10&&(c<0&&(h=Wt(h,-c)),u<0&&(f=Wt(f,-u))),i||t==2?(n=h*r,e=f*s):(n=ud(n,h),e=hc(e,f)),[n,e]}function Ah(n,e,t,i){let r=uc(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var Rh=.1,Pp={mode:3,pad:Rh},Ma={pad:0,soft:null,mode:0},yM={min:Ma,max:Ma};function ac(n,e,t,i){return fc(t)?Lp(n,e,t):(Ma.pad=t,Ma.soft=i?0:null,Ma.mode=i?3:0,Lp(n,e,yM))}function Dt(n,e){return n??e}function SM(n,e,t){for(e=Dt(e,0),t=Dt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Lp(n,e,t){let i=t.min,r=t.max,s=Dt(i.pad,0),o=Dt(r.pad,0),a=Dt(i.hard,-Vt),l=Dt(r.hard,Vt),c=Dt(i.soft,Vt),u=Dt(r.soft,-Vt),h=Dt(i.mode,0),f=Dt(r.mode,0),p=e-n,m=br(p),M=ji(yi(n),yi(e)),d=br(M),g=yi(d-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Vt&&(s=0),f==2&&u!=-Vt&&(o=0)));let v=p||M||1e3,T=br(v),y=js(10,fn(T)),C=v*(p==0?n==0?.1:1:s),A=Wt(ud(n-C,y/10),24),x=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Vt,w=ji(a,A<x&&n>=x?x:Wn(x,A)),B=v*(p==0?e==0?.1:1:o),D=Wt(hc(e+B,y/10),24),L=e<=u&&(f==1||f==3&&D>=u||f==2&&D<=u)?u:-Vt,z=Wn(l,D>L&&e<=L?L:ji(L,D));return w==z&&w==0&&(z=100),[w,z]}var bM=new Intl.NumberFormat(no?xM.language:"en-US"),Ch=n=>bM.format(n),pn=Math,sc=pn.PI,yi=pn.abs,fn=pn.floor,Mi=pn.round,An=pn.ceil,Wn=pn.min,ji=pn.max,js=pn.pow,Dp=pn.sign,br=pn.log10,od=pn.log2,wM=(n,e=1)=>pn.sinh(n)*e,uh=(n,e=1)=>pn.asinh(n/e),Vt=1/0;function Ip(n){return(br((n^n>>31)-(n>>31))|0)+1}function _h(n,e,t){return Wn(ji(n,e),t)}function ad(n){return typeof n=="function"}function Ct(n){return ad(n)?n:()=>n}var EM=()=>{},ld=n=>n,cd=(n,e)=>e,TM=n=>null,Fp=n=>!0,Up=(n,e)=>n==e,AM=/\.\d*?(?=9{6,}|0{6,})/gm,vs=n=>{if(fd(n)||Wr.has(n))return n;let e=`${n}`,t=e.match(AM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${vs(r)}e${s}`}return Wt(n,i)};function ms(n,e){return vs(Wt(vs(n/e))*e)}function hc(n,e){return vs(An(vs(n/e))*e)}function ud(n,e){return vs(fn(vs(n/e))*e)}function Wt(n,e=0){if(fd(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mi(i)/t}var Wr=new Map;function hd(n){return((""+n).split(".")[1]||"").length}function Sa(n,e,t,i){let r=[],s=i.map(hd);for(let o=e;o<t;o++){let a=yi(o),l=Wt(js(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=n==10?u:Wt(u,h);r.push(f),Wr.set(f,h)}}return r}var ya={},Ph=[],eo=[null,null],Vr=Array.isArray,fd=Number.isInteger,RM=n=>n===void 0;function Np(n){return typeof n=="string"}function fc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function CM(n){return n!=null&&typeof n=="object"}var PM=Object.getPrototypeOf(Uint8Array),pd="__proto__";function to(n,e=fc){let t;if(Vr(n)){let i=n.find(r=>r!=null);if(Vr(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=to(n[r],e)}else t=n.slice()}else if(n instanceof PM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=pd&&(t[i]=to(n[i],e))}else t=n;return t}function gi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=pd&&(fc(n[r])?gi(n[r],to(i[r])):n[r]=to(i[r]))}return n}var LM=0,DM=1,IM=2;function FM(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function UM(n,e){if(BM(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return kM(o[0])||(o=OM(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=e?e[o][c]:DM,p=[];for(let m=0;m<u.length;m++){let M=u[m],d=s.get(l[m]);M===null?f!=LM&&(h[d]=M,f==IM&&p.push(d)):h[d]=M}FM(h,p,r),i.push(h)}}return i}var NM=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function OM(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function BM(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function kM(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ji(1,fn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var dd=["January","February","March","April","May","June","July","August","September","October","November","December"],md=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function gd(n){return n.slice(0,3)}var zM=md.map(gd),GM=dd.map(gd),HM={MMMM:dd,MMM:GM,WWWW:md,WWW:zM};function ga(n){return(n<10?"0":"")+n}function VM(n){return(n<10?"00":n<100?"0":"")+n}var WM={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ga(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ga(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ga(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ga(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ga(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>VM(n.getMilliseconds())};function Lh(n,e){e=e||HM;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?WM[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var XM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function qM(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==XM?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var xd=n=>n%1==0,lc=[1,2,2.5,5],YM=Sa(10,-32,0,lc),_d=Sa(10,0,32,lc),$M=_d.filter(xd),gs=YM.concat(_d),Dh=`
`,vd="{YYYY}",Op=Dh+vd,Md="{M}/{D}",va=Dh+Md,nc=va+"/{YY}",yd="{aa}",KM="{h}:{mm}",Js=KM+yd,Bp=Dh+Js,kp=":{ss}",Ot=null;function Sd(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Sa(10,0,3,lc).filter(xd):Sa(10,-3,0,lc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,vd,Ot,Ot,Ot,Ot,Ot,Ot,1],[r*28,"{MMM}",Op,Ot,Ot,Ot,Ot,Ot,1],[r,Md,Op,Ot,Ot,Ot,Ot,Ot,1],[i,"{h}"+yd,nc,Ot,va,Ot,Ot,Ot,1],[t,Js,nc,Ot,va,Ot,Ot,Ot,1],[e,kp,nc+" "+Js,Ot,va+" "+Js,Ot,Bp,Ot,1],[n,kp+".{fff}",nc+" "+Js,Ot,va+" "+Js,Ot,Bp,Ot,1]];function u(h){return(f,p,m,M,d,g)=>{let v=[],T=d>=o,y=d>=s&&d<o,C=h(m),A=Wt(C*n,3),x=hh(C.getFullYear(),T?0:C.getMonth(),y||T?1:C.getDate()),w=Wt(x*n,3);if(y||T){let B=y?d/s:0,D=T?d/o:0,L=A==w?A:Wt(hh(x.getFullYear()+D,x.getMonth()+B,1)*n,3),z=new Date(Mi(L/n)),W=z.getFullYear(),I=z.getMonth();for(let H=0;L<=M;H++){let q=hh(W+D*H,I+B*H,1),G=q-h(Wt(q*n,3));L=Wt((+q+G)*n,3),L<=M&&v.push(L)}}else{let B=d>=r?r:d,D=fn(m)-fn(A),L=w+D+hc(A-w,B);v.push(L);let z=h(L),W=z.getHours()+z.getMinutes()/t+z.getSeconds()/i,I=d/i,H=f.axes[p]._space,q=g/H;for(;L=Wt(L+d,n==1?0:3),!(L>M);)if(I>1){let G=fn(Wt(W+I,6))%24,Q=h(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,W=(W+I)%24;let ee=v[v.length-1];Wt((L-ee)/d,3)*q>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[ZM,JM,QM]=Sd(1),[jM,ey,ty]=Sd(.001);Sa(2,-53,53,[1]);function zp(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function Gp(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,p;return i.map(m=>{let M=n(m),d=M.getFullYear(),g=M.getMonth(),v=M.getDate(),T=M.getHours(),y=M.getMinutes(),C=M.getSeconds(),A=d!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||y!=f&&a[6]||C!=p&&a[7]||a[1];return l=d,c=g,u=v,h=T,f=y,p=C,A(M)})}}function iy(n,e){let t=Lh(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function hh(n,e,t){return new Date(n,e,t)}function Hp(n,e){return e(n)}var ny="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vp(n,e){return(t,i,r,s)=>s==null?Eh:e(n(i))}function ry(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function sy(n,e){return n.series[e].fill(n,e)}var oy={show:!0,live:!0,isolate:!1,mount:EM,markers:{show:!0,width:2,stroke:ry,fill:sy,dash:"solid"},idx:null,idxs:null,values:[]};function ay(n,e){let t=n.cursor.points,i=Tn(),r=t.size(n,e);Kt(i,xa,r),Kt(i,_a,r);let s=r/-2;Kt(i,"marginLeft",s),Kt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Kt(i,"borderWidth",o),i}function ly(n,e){let t=n.series[e].points;return t._fill||t._stroke}function cy(n,e){let t=n.series[e].points;return t._stroke||t._fill}function uy(n,e){return n.series[e].points.size}var fh=[0,0];function hy(n,e,t){return fh[0]=e,fh[1]=t,fh}function rc(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function ph(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var fy={show:!0,x:!0,y:!0,lock:!1,move:hy,points:{one:!1,show:ay,size:uy,width:0,stroke:cy,fill:ly},bind:{mousedown:rc,mouseup:rc,click:rc,dblclick:rc,mousemove:ph,mouseleave:ph,mouseenter:ph},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ih=gi({},bd,{filter:cd}),wd=gi({},Ih,{size:10}),Ed=gi({},bd,{show:!1}),Fh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Td="bold "+Fh,Ad=1.5,Wp={show:!0,scale:"x",stroke:wh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Td,side:2,grid:Ih,ticks:wd,border:Ed,font:Fh,lineGap:Ad,rotate:0},py="Value",dy="Time",Xp={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function my(n,e,t,i,r){return e.map(s=>s==null?"":Ch(s))}function gy(n,e,t,i,r,s,o){let a=[],l=Wr.get(r)||0;t=o?t:Wt(hc(t,r),l);for(let c=t;c<=i;c=Wt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function vh(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?br:od,u=fn(c(t));r=js(l,u),l==10&&(r=gs[Vn(r,gs)]);let h=t,f=r*l;l==10&&(f=gs[Vn(f,gs)]);do a.push(h),h=h+r,l==10&&!Wr.has(h)&&(h=Wt(h,Wr.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=gs[Vn(f,gs)]));while(h<=i);return a}function xy(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?vh(n,e,ji(l,t),i,r):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?vh(n,e,ji(l,-i),-t,r):[l]).reverse().map(f=>-f).concat(u,c)}var Rd=/./,_y=/[12357]/,vy=/[125]/,qp=/1/,Mh=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function My(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?Rd:l(7,o)-u>=c?_y:l(5,o)-u>=c?vy:qp;if(h==qp){let f=yi(l(1,o)-u);if(f<c)return Mh(e.slice().reverse(),a.distr,h,An(c/f)).reverse()}return Mh(e,a.distr,h,1)}function yy(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=yi(l(1,o)-l(2,o));return c<a?Mh(e.slice().reverse(),3,Rd,An(a/c)).reverse():e}function Sy(n,e,t,i){return i==null?Eh:e==null?"":Ch(e)}var Yp={show:!0,scale:"y",stroke:wh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Td,side:3,grid:Ih,ticks:wd,border:Ed,font:Fh,lineGap:Ad,rotate:0};function by(n,e){let t=3+(n||1)*2;return Wt(t*e,3)}function wy(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=yi(o-s),l=n.series[e],c=a/(l.points.space*Ut);return i[1]-i[0]<=c}var $p={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},Cd=(n,e,t,i,r)=>r,Kp={show:!0,auto:!0,sorted:0,gaps:Cd,alpha:1,facets:[gi({},$p,{scale:"x"}),gi({},$p,{scale:"y"})]},Zp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Cd,alpha:1,points:{show:wy,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function Ey(n,e,t,i,r){return t/10}var Pd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ty=gi({},Pd,{time:!1,ori:1}),Jp={};function Ld(n,e){let t=Jp[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(i,r,s,o,a,l,c)}},n!=null&&(Jp[n]=t)),t}var io=1,yh=2;function Ms(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],u=i==2?o[r.facets[0].scale]:o[n.series[0].scale],h=i==2?o[r.facets[1].scale]:o[r.scale],f=a.left,p=a.top,m=a.width,M=a.height,d=n.valToPosH,g=n.valToPosV;return u.ori==0?t(r,l,c,u,h,d,g,f,p,m,M,dc,ro,gc,Id,Ud):t(r,l,c,u,h,g,d,p,f,M,m,mc,so,Oh,Fd,Nd)}function Uh(n,e){let t=0,i=0,r=Dt(n.bands,Ph);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Ay(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function wr(n,e,t,i,r,s){return Ms(n,e,(o,a,l,c,u,h,f,p,m,M,d)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?ro:so,y,C;v==1?(y=t,C=i):(y=i,C=t);let A=g(h(a[y],c,M,p)),x=g(f(l[y],u,d,m)),w=g(h(a[C],c,M,p)),B=g(f(s==1?u.max:u.min,u,d,m)),D=new Path2D(r);return T(D,w,B),T(D,A,B),T(D,A,x),D})}function pc(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?gc:Oh,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+s),l=f[1]}}let c=t+r-l,u=10;c>0&&a(o,l,i-u/2,c,i+s+u)}return o}function Ry(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Nh(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let h=c,f=c;if(r==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=s(n[h]),m=f==h?p:s(n[f]),M=h-r;p=o<=0&&M>=0&&M<l?s(n[M]):p;let g=f+r;m=o>=0&&g>=0&&g<l?s(n[g]):m,m>=p&&a.push([p,m])}return a}function Qp(n){return n==0?ld:n==1?Mi:e=>ms(e,n)}function Dd(n){let e=n==0?dc:mc,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?i(r,s,o,a,l):(c=Wn(c,a/2,l/2),u=Wn(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var dc=(n,e,t)=>{n.moveTo(e,t)},mc=(n,e,t)=>{n.moveTo(t,e)},ro=(n,e,t)=>{n.lineTo(e,t)},so=(n,e,t)=>{n.lineTo(t,e)},gc=Dd(0),Oh=Dd(1),Id=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Fd=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Ud=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Nd=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function Od(n){return(e,t,i,r,s)=>Ms(e,t,(o,a,l,c,u,h,f,p,m,M,d)=>{let{pxRound:g,points:v}=o,T,y;c.ori==0?(T=dc,y=Id):(T=mc,y=Fd);let C=Wt(v.width*Ut,3),A=(v.size-v.width)/2*Ut,x=Wt(A*2,3),w=new Path2D,B=new Path2D,{left:D,top:L,width:z,height:W}=e.bbox;gc(B,D-x,L-x,z+x*2,W+x*2);let I=H=>{if(l[H]!=null){let q=g(h(a[H],c,M,p)),G=g(f(l[H],u,d,m));T(w,q+A,G),y(w,q,G,A,0,sc*2)}};if(s)s.forEach(I);else for(let H=i;H<=r;H++)I(H);return{stroke:C>0?w:null,fill:w,clip:B,flags:io|yh}})}function Bd(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var Cy=Bd(ro),Py=Bd(so);function kd(n){let e=Dt(n?.alignGaps,0);return(t,i,r,s)=>Ms(t,i,(o,a,l,c,u,h,f,p,m,M,d)=>{[r,s]=cc(l,r,s);let g=o.pxRound,v=W=>g(h(W,c,M,p)),T=W=>g(f(W,u,d,m)),y,C;c.ori==0?(y=ro,C=Cy):(y=so,C=Py);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},w=x.stroke,B=!1;if(s-r>=M*4){let W=ue=>t.posToVal(ue,c.key,!0),I=null,H=null,q,G,ce,K=v(a[A==1?r:s]),Q=v(a[r]),ee=v(a[s]),de=W(A==1?Q+1:ee-1);for(let ue=A==1?r:s;ue>=r&&ue<=s;ue+=A){let j=a[ue],ve=(A==1?j<de:j>de)?K:v(j),De=l[ue];ve==K?De!=null?(G=De,I==null?(y(w,ve,T(G)),q=I=H=G):G<I?I=G:G>H&&(H=G)):De===null&&(B=!0):(I!=null&&C(w,K,T(I),T(H),T(q),T(G)),De!=null?(G=De,y(w,ve,T(G)),I=H=q=G):(I=H=null,De===null&&(B=!0)),K=ve,de=W(K+A))}I!=null&&I!=H&&ce!=K&&C(w,K,T(I),T(H),T(q),T(G))}else for(let W=A==1?r:s;W>=r&&W<=s;W+=A){let I=l[W];I===null?B=!0:I!=null&&y(w,v(a[W]),T(I))}let[L,z]=Uh(t,i);if(o.fill!=null||L!=0){let W=x.fill=new Path2D(w),I=o.fillTo(t,i,o.min,o.max,L),H=T(I),q=v(a[r]),G=v(a[s]);A==-1&&([G,q]=[q,G]),y(W,G,H),y(W,q,H)}if(!o.spanGaps){let W=[];B&&W.push(...Nh(a,l,r,s,A,v,e)),x.gaps=W=o.gaps(t,i,r,s,W),x.clip=pc(W,c.ori,p,m,M,d)}return z!=0&&(x.band=z==2?[wr(t,i,r,s,w,-1),wr(t,i,r,s,w,1)]:wr(t,i,r,s,w,z)),x})}function Ly(n){let e=Dt(n.align,1),t=Dt(n.ascDesc,!1),i=Dt(n.alignGaps,0),r=Dt(n.extend,!1);return(s,o,a,l)=>Ms(s,o,(c,u,h,f,p,m,M,d,g,v,T)=>{[a,l]=cc(h,a,l);let y=c.pxRound,{left:C,width:A}=s.bbox,x=Q=>y(m(Q,f,v,d)),w=Q=>y(M(Q,p,T,g)),B=f.ori==0?ro:so,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},L=D.stroke,z=f.dir*(f.ori==0?1:-1),W=w(h[z==1?a:l]),I=x(u[z==1?a:l]),H=I,q=I;r&&e==-1&&(q=C,B(L,q,W)),B(L,I,W);for(let Q=z==1?a:l;Q>=a&&Q<=l;Q+=z){let ee=h[Q];if(ee==null)continue;let de=x(u[Q]),ue=w(ee);e==1?B(L,de,W):B(L,H,ue),B(L,de,ue),W=ue,H=de}let G=H;r&&e==1&&(G=C+A,B(L,G,W));let[ce,K]=Uh(s,o);if(c.fill!=null||ce!=0){let Q=D.fill=new Path2D(L),ee=c.fillTo(s,o,c.min,c.max,ce),de=w(ee);B(Q,G,de),B(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...Nh(u,h,a,l,z,x,i));let ee=c.width*Ut/2,de=t||e==1?ee:-ee,ue=t||e==-1?-ee:ee;Q.forEach(j=>{j[0]+=de,j[1]+=ue}),D.gaps=Q=c.gaps(s,o,a,l,Q),D.clip=pc(Q,f.ori,d,g,v,T)}return K!=0&&(D.band=K==2?[wr(s,o,a,l,L,-1),wr(s,o,a,l,L,1)]:wr(s,o,a,l,L,K)),D})}function jp(n,e,t,i,r,s,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=yi(n[l]-n[a]);u<c&&(c=u,o=yi(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function Dy(n){n=n||ya;let e=Dt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=Ct(r),o=1-e[0],a=Dt(e[1],Vt),l=Dt(e[2],1),c=Dt(n.disp,ya),u=Dt(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,m,M,d)=>Ms(p,m,(g,v,T,y,C,A,x,w,B,D,L)=>{let z=g.pxRound,W=t,I=i*Ut,H=a*Ut,q=l*Ut,G,ce;y.ori==0?[G,ce]=s(p,m):[ce,G]=s(p,m);let K=y.dir*(y.ori==0?1:-1),Q=y.ori==0?gc:Oh,ee=y.ori==0?u:(Se,qe,ht,Ee,Nt,Ke,it)=>{u(Se,qe,ht,Nt,Ee,it,Ke)},de=Dt(p.bands,Ph).find(Se=>Se.series[0]==m),ue=de!=null?de.dir:0,j=g.fillTo(p,m,g.min,g.max,ue),xe=z(x(j,C,L,B)),ve,De,we,He=D,ot=z(g.width*Ut),Je=!1,at=null,rt=null,se=null,Me=null;h!=null&&(ot==0||f!=null)&&(Je=!0,at=h.values(p,m,M,d),rt=new Map,new Set(at).forEach(Se=>{Se!=null&&rt.set(Se,new Path2D)}),ot>0&&(se=f.values(p,m,M,d),Me=new Map,new Set(se).forEach(Se=>{Se!=null&&Me.set(Se,new Path2D)})));let{x0:_e,size:Be}=c;if(_e!=null&&Be!=null){W=1,v=_e.values(p,m,M,d),_e.unit==2&&(v=v.map(ht=>p.posToVal(w+ht*D,y.key,!0)));let Se=Be.values(p,m,M,d);Be.unit==2?De=Se[0]*D:De=A(Se[0],y,D,w)-A(0,y,D,w),He=jp(v,T,A,y,D,w,He),we=He-De+I}else He=jp(v,T,A,y,D,w,He),we=He*o+I,De=He-we;we<1&&(we=0),ot>=De/2&&(ot=0),we<5&&(z=ld);let Ie=we>0,nt=He-we-(Ie?ot:0);De=z(_h(nt,q,H)),ve=(W==0?De/2:W==K?0:De)-W*K*((W==0?I/2:0)+(Ie?ot/2:0));let ke={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gt=Je?null:new Path2D,pt=null;if(de!=null)pt=p.data[de.series[1]];else{let{y0:Se,y1:qe}=c;Se!=null&&qe!=null&&(T=qe.values(p,m,M,d),pt=Se.values(p,m,M,d))}let yt=G*De,U=ce*De;for(let Se=K==1?M:d;Se>=M&&Se<=d;Se+=K){let qe=T[Se];if(qe==null)continue;if(pt!=null){let X=pt[Se]??0;if(qe-X==0)continue;xe=x(X,C,L,B)}let ht=y.distr!=2||c!=null?v[Se]:Se,Ee=A(ht,y,D,w),Nt=x(Dt(qe,j),C,L,B),Ke=z(Ee-ve),it=z(ji(Nt,xe)),R=z(Wn(Nt,xe)),S=it-R;if(qe!=null){let X=qe<0?U:yt,pe=qe<0?yt:U;Je?(ot>0&&se[Se]!=null&&Q(Me.get(se[Se]),Ke,R+fn(ot/2),De,ji(0,S-ot),X,pe),at[Se]!=null&&Q(rt.get(at[Se]),Ke,R+fn(ot/2),De,ji(0,S-ot),X,pe)):Q(gt,Ke,R+fn(ot/2),De,ji(0,S-ot),X,pe),ee(p,m,Se,Ke-ot/2,R,De+ot,S)}}return ot>0?ke.stroke=Je?Me:gt:Je||(ke._fill=g.width==0?g._fill:g._stroke??g._fill,ke.width=0),ke.fill=Je?rt:gt,ke})}function Iy(n,e){let t=Dt(e?.alignGaps,0);return(i,r,s,o)=>Ms(i,r,(a,l,c,u,h,f,p,m,M,d,g)=>{[s,o]=cc(c,s,o);let v=a.pxRound,T=G=>v(f(G,u,d,m)),y=G=>v(p(G,h,g,M)),C,A,x;u.ori==0?(C=dc,x=ro,A=Ud):(C=mc,x=so,A=Nd);let w=u.dir*(u.ori==0?1:-1),B=T(l[w==1?s:o]),D=B,L=[],z=[];for(let G=w==1?s:o;G>=s&&G<=o;G+=w)if(c[G]!=null){let K=l[G],Q=T(K);L.push(D=Q),z.push(y(c[G]))}let W={stroke:n(L,z,C,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:io},I=W.stroke,[H,q]=Uh(i,r);if(a.fill!=null||H!=0){let G=W.fill=new Path2D(I),ce=a.fillTo(i,r,a.min,a.max,H),K=y(ce);x(G,D,K),x(G,B,K)}if(!a.spanGaps){let G=[];G.push(...Nh(l,c,s,o,w,T,t)),W.gaps=G=a.gaps(i,r,s,o,G),W.clip=pc(G,u.ori,m,M,d,g)}return q!=0&&(W.band=q==2?[wr(i,r,s,o,I,-1),wr(i,r,s,o,I,1)]:wr(i,r,s,o,I,q)),W})}function Fy(n){return Iy(Uy,n)}function Uy(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var Sh=new Set;function ed(){for(let n of Sh)n.syncRect(!0)}no&&(_s(mM,Qs,ed),_s(gM,Qs,ed,!0),_s(oc,Qs,()=>{Bi.pxRatio=Ut}));var Ny=kd(),Oy=Od();function td(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>bh(s,o,e,t))}function By(n,e){return n.map((t,i)=>i==0?{}:gi({},e,t))}function bh(n,e,t,i){return gi({},e==0?t:i,n)}function zd(n,e,t){return e==null?eo:[e,t]}var ky=zd;function zy(n,e,t){return e==null?eo:ac(e,t,Rh,!0)}function Gd(n,e,t,i){return e==null?eo:uc(e,t,n.scales[i].log,!1)}var Gy=Gd;function Hd(n,e,t,i){return e==null?eo:Ah(e,t,n.scales[i].log,!1)}var Hy=Hd;function Vy(n,e,t,i,r){let s=ji(Ip(n),Ip(e)),o=e-n,a=Vn(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Wr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function id(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Mi((t=+r)*Ut))+"px"),[n,e,t]}function Wy(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Wt(e[2]*Ut,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Bi(n,e,t){let i={mode:Dt(n.mode,1)},r=i.mode;function s(_,b,P,F){let V=b.valToPct(_);return F+P*(b.dir==-1?1-V:V)}function o(_,b,P,F){let V=b.valToPct(_);return F+P*(b.dir==-1?V:1-V)}function a(_,b,P,F){return b.ori==0?s(_,b,P,F):o(_,b,P,F)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Tn(Jv);if(n.id!=null&&(c.id=n.id),hn(c,n.class),n.title){let _=Tn(eM,c);_.textContent=n.title}let u=Hn("canvas"),h=i.ctx=u.getContext("2d"),f=Tn(tM,c);_s("click",f,_=>{_.target===m&&(qt!=Hs||Zt!=Vs)&&Ni.click(i,_)},!0);let p=i.under=Tn(iM,f);f.appendChild(u);let m=i.over=Tn(nM,f);n=to(n);let M=+Dt(n.pxAlign,1),d=Qp(M);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let g=n.ms||.001,v=i.series=r==1?td(n.series||[],Xp,Zp,!1):By(n.series||[null],Kp),T=i.axes=td(n.axes||[],Wp,Yp,!0),y=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=Ct(_.fill||null),_.dir=Dt(_.dir,-1)});let A=r==2?v[1].facets[0].scale:v[0].scale,x={axes:vr,series:Et},w=(n.drawOrder||["axes","series"]).map(_=>x[_]);function B(_){let b=_.distr==3?P=>br(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>uh(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let F=b(P),{_min:V,_max:Z}=_,ae=Z-V;return(F-V)/ae}}function D(_){let b=y[_];if(b==null){let P=(n.scales||ya)[_]||ya;if(P.from!=null){D(P.from);let F=gi({},y[P.from],P,{key:_});F.valToPct=B(F),y[_]=F}else{b=y[_]=gi({},_==A?Pd:Ty,P),b.key=_;let F=b.time,V=b.range,Z=Vr(V);if((_!=A||r==2&&!F)&&(Z&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Pp:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Pp:{mode:1,hard:V[1],soft:V[1]}},Z=!1),!Z&&fc(V))){let ae=V;V=(me,Ae,ze)=>Ae==null?eo:ac(Ae,ze,ae)}b.range=Ct(V||(F?ky:_==A?b.distr==3?Gy:b.distr==4?Hy:zd:b.distr==3?Gd:b.distr==4?Hd:zy)),b.auto=Ct(Z?!1:b.auto),b.clamp=Ct(b.clamp||Ey),b._min=b._max=null,b.valToPct=B(b)}}}D("x"),D("y"),r==1&&v.forEach(_=>{D(_.scale)}),T.forEach(_=>{D(_.scale)});for(let _ in n.scales)D(_);let L=y[A],z=L.distr,W,I;L.ori==0?(hn(c,Qv),W=s,I=o):(hn(c,jv),W=o,I=s);let H={};for(let _ in y){let b=y[_];(b.min!=null||b.max!=null)&&(H[_]={min:b.min,max:b.max},b.min=b.max=null)}let q=n.tzDate||(_=>new Date(Mi(_/g))),G=n.fmtDate||Lh,ce=g==1?QM(q):ty(q),K=Gp(q,zp(g==1?JM:ey,G)),Q=Vp(q,Hp(ny,G)),ee=[],de=i.legend=gi({},oy,n.legend),ue=i.cursor=gi({},fy,{drag:{y:r==2}},n.cursor),j=de.show,xe=ue.show,ve=de.markers;de.idxs=ee,ve.width=Ct(ve.width),ve.dash=Ct(ve.dash),ve.stroke=Ct(ve.stroke),ve.fill=Ct(ve.fill);let De,we,He,ot=[],Je=[],at,rt=!1,se={};if(de.live){let _=v[1]?v[1].values:null;rt=_!=null,at=rt?_(i,1,0):{_:0};for(let b in at)se[b]=Eh}if(j)if(De=Hn("table",cM,c),He=Hn("tbody",null,De),de.mount(i,De),rt){we=Hn("thead",null,De,He);let _=Hn("tr",null,we);Hn("th",null,_);for(var Me in at)Hn("th",xp,_).textContent=Me}else hn(De,hM),de.live&&hn(De,uM);let _e={show:!0},Be={show:!1};function Ie(_,b){if(b==0&&(rt||!de.live||r==2))return eo;let P=[],F=Hn("tr",fM,He,He.childNodes[b]);hn(F,_.class),_.show||hn(F,xs);let V=Hn("th",null,F);if(ve.show){let me=Tn(pM,V);if(b>0){let Ae=ve.width(i,b);Ae&&(me.style.border=Ae+"px "+ve.dash(i,b)+" "+ve.stroke(i,b)),me.style.background=ve.fill(i,b)}}let Z=Tn(xp,V);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,b>0&&(ve.show||(Z.style.color=_.width>0?ve.stroke(i,b):ve.fill(i,b)),ke("click",V,me=>{if(ue._lock)return;ct(me);let Ae=v.indexOf(_);if((me.ctrlKey||me.metaKey)!=de.isolate){let ze=v.some((Ge,We)=>We>0&&We!=Ae&&Ge.show);v.forEach((Ge,We)=>{We>0&&rr(We,ze?We==Ae?_e:Be:_e,!0,mi.setSeries)})}else rr(Ae,{show:!_.show},!0,mi.setSeries)},!1),ut&&ke(yp,V,me=>{ue._lock||(ct(me),rr(v.indexOf(_),Xs,!0,mi.setSeries))},!1));for(var ae in at){let me=Hn("td",dM,F);me.textContent="--",P.push(me)}return[F,P]}let nt=new Map;function ke(_,b,P,F=!0){let V=nt.get(b)||{},Z=ue.bind[_](i,b,P,F);Z&&(_s(_,b,V[_]=Z),nt.set(b,V))}function gt(_,b,P){let F=nt.get(b)||{};for(let V in F)(_==null||V==_)&&(xh(V,b,F[V]),delete F[V]);_==null&&nt.delete(b)}let pt=0,yt=0,U=0,Se=0,qe=0,ht=0,Ee=qe,Nt=ht,Ke=U,it=Se,R=0,S=0,X=0,pe=0;i.bbox={};let oe=!1,be=!1,Te=!1,te=!1,ne=!1,ge=!1;function N(_,b,P){(P||_!=i.width||b!=i.height)&&re(_,b),St(!1),Te=!0,be=!0,Gi()}function re(_,b){i.width=pt=U=_,i.height=yt=Se=b,qe=ht=0,Re(),Qe();let P=i.bbox;R=P.left=ms(qe*Ut,.5),S=P.top=ms(ht*Ut,.5),X=P.width=ms(U*Ut,.5),pe=P.height=ms(Se*Ut,.5)}let ie=3;function Ce(){let _=!1,b=0;for(;!_;){b++;let P=ks(b),F=nr(b);_=b==ie||P&&F,_||(re(i.width,i.height),be=!0)}}function ye({width:_,height:b}){N(_,b)}i.setSize=ye;function Re(){let _=!1,b=!1,P=!1,F=!1;T.forEach((V,Z)=>{if(V.show&&V._show){let{side:ae,_size:me}=V,Ae=ae%2,ze=V.label!=null?V.labelSize:0,Ge=me+ze;Ge>0&&(Ae?(U-=Ge,ae==3?(qe+=Ge,F=!0):P=!0):(Se-=Ge,ae==0?(ht+=Ge,_=!0):b=!0))}}),tr[0]=_,tr[1]=P,tr[2]=b,tr[3]=F,U-=Bn[1]+Bn[3],qe+=Bn[3],Se-=Bn[2]+Bn[0],ht+=Bn[0]}function Qe(){let _=qe+U,b=ht+Se,P=qe,F=ht;function V(Z,ae){switch(Z){case 1:return _+=ae,_-ae;case 2:return b+=ae,b-ae;case 3:return P-=ae,P+ae;case 0:return F-=ae,F+ae}}T.forEach((Z,ae)=>{if(Z.show&&Z._show){let me=Z.side;Z._pos=V(me,Z._size),Z.label!=null&&(Z._lpos=V(me,Z.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let P=_.prox=Ct(_.prox),F=_.bias??=0;ue.dataIdx=(V,Z,ae,me)=>{if(Z==0)return ae;let Ae=ae,ze=P(V,Z,ae,me)??Vt,Ge=ze>=0&&ze<Vt,We=L.ori==0?U:Se,dt=ue.left,Ft=e[0],Lt=e[Z];if(b.has(Lt[ae])){Ae=null;let Tt=null,lt=null,je;if(F==0||F==-1)for(je=ae;Tt==null&&je-- >0;)b.has(Lt[je])||(Tt=je);if(F==0||F==1)for(je=ae;lt==null&&je++<Lt.length;)b.has(Lt[je])||(lt=je);if(Tt!=null||lt!=null)if(Ge){let $t=Tt==null?-1/0:W(Ft[Tt],L,We,0),si=lt==null?1/0:W(Ft[lt],L,We,0),Pi=dt-$t,Ht=si-dt;Pi<=Ht?Pi<=ze&&(Ae=Tt):Ht<=ze&&(Ae=lt)}else Ae=lt==null?Tt:Tt==null?lt:ae-Tt<=lt-ae?Tt:lt}else Ge&&yi(dt-W(Ft[ae],L,We,0))>ze&&(Ae=null);return Ae}}let ct=_=>{ue.event=_};ue.idxs=ee,ue._lock=!1;let fe=ue.points;fe.show=Ct(fe.show),fe.size=Ct(fe.size),fe.stroke=Ct(fe.stroke),fe.width=Ct(fe.width),fe.fill=Ct(fe.fill);let Ye=i.focus=gi({},n.focus||{alpha:.3},ue.focus),ut=Ye.prox>=0,Fe=ut&&fe.one,Mt=[],Xt=[],Yi=[];function sa(_,b){let P=fe.show(i,b);if(P instanceof HTMLElement)return hn(P,lM),hn(P,_.class),cr(P,-10,-10,U,Se),m.insertBefore(P,Mt[b]),P}function Ns(_,b){if(r==1||b>0){let P=r==1&&y[_.scale].time,F=_.value;_.value=P?Np(F)?Vp(q,Hp(F,G)):F||Q:F||Sy,_.label=_.label||(P?dy:py)}if(Fe||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Ny||TM,_.fillTo=Ct(_.fillTo||Ay),_.pxAlign=+Dt(_.pxAlign,M),_.pxRound=Qp(_.pxAlign),_.stroke=Ct(_.stroke||null),_.fill=Ct(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=by(ji(1,_.width),1),F=_.points=gi({},{size:P,width:ji(1,P*.2),stroke:_.stroke,space:P*2,paths:Oy,_stroke:null,_fill:null},_.points);F.show=Ct(F.show),F.filter=Ct(F.filter),F.fill=Ct(F.fill),F.stroke=Ct(F.stroke),F.paths=Ct(F.paths),F.pxAlign=_.pxAlign}if(j){let P=Ie(_,b);ot.splice(b,0,P[0]),Je.splice(b,0,P[1]),de.values.push(null)}if(xe){ee.splice(b,0,null);let P=null;Fe?b==0&&(P=sa(_,b)):b>0&&(P=sa(_,b)),Mt.splice(b,0,P),Xt.splice(b,0,0),Yi.splice(b,0,0)}Ci("addSeries",b)}function Yu(_,b){b=b??v.length,_=r==1?bh(_,b,Xp,Zp):bh(_,b,{},Kp),v.splice(b,0,_),Ns(v[b],b)}i.addSeries=Yu;function Ul(_){if(v.splice(_,1),j){de.values.splice(_,1),Je.splice(_,1);let b=ot.splice(_,1)[0];gt(null,b.firstChild),b.remove()}xe&&(ee.splice(_,1),Mt.splice(_,1)[0].remove(),Xt.splice(_,1),Yi.splice(_,1)),Ci("delSeries",_)}i.delSeries=Ul;let tr=[!1,!1,!1,!1];function gr(_,b){if(_._show=_.show,_.show){let P=_.side%2,F=y[_.scale];F==null&&(_.scale=P?v[1].scale:A,F=y[_.scale]);let V=F.time;_.size=Ct(_.size),_.space=Ct(_.space),_.rotate=Ct(_.rotate),Vr(_.incrs)&&_.incrs.forEach(ae=>{!Wr.has(ae)&&Wr.set(ae,hd(ae))}),_.incrs=Ct(_.incrs||(F.distr==2?$M:V?g==1?ZM:jM:gs)),_.splits=Ct(_.splits||(V&&F.distr==1?ce:F.distr==3?vh:F.distr==4?xy:gy)),_.stroke=Ct(_.stroke),_.grid.stroke=Ct(_.grid.stroke),_.ticks.stroke=Ct(_.ticks.stroke),_.border.stroke=Ct(_.border.stroke);let Z=_.values;_.values=Vr(Z)&&!Vr(Z[0])?Ct(Z):V?Vr(Z)?Gp(q,zp(Z,G)):Np(Z)?iy(q,Z):Z||K:Z||my,_.filter=Ct(_.filter||(F.distr>=3&&F.log==10?My:F.distr==3&&F.log==2?yy:cd)),_.font=id(_.font),_.labelFont=id(_.labelFont),_._size=_.size(i,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(tr[b]=!0,_._el=Tn(rM,f))}}function xr(_,b,P,F){let[V,Z,ae,me]=P,Ae=b%2,ze=0;return Ae==0&&(me||Z)&&(ze=b==0&&!V||b==2&&!ae?Mi(Wp.size/3):0),Ae==1&&(V||ae)&&(ze=b==1&&!Z||b==3&&!me?Mi(Yp.size/2):0),ze}let oa=i.padding=(n.padding||[xr,xr,xr,xr]).map(_=>Ct(Dt(_,xr))),Bn=i._padding=oa.map((_,b)=>_(i,b,tr,0)),ni,li=null,ci=null,ir=r==1?v[0].idxs:null,sn=null,Fr=!1;function aa(_,b){if(e=_??[],i.data=i._data=e,r==2){ni=0;for(let P=1;P<v.length;P++)ni+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),sn=e[0],ni=sn.length;let P=e;if(z==2){P=e.slice();let F=P[0]=Array(ni);for(let V=0;V<ni;V++)F[V]=V}i._data=e=P}if(St(!0),Ci("setData"),z==2&&(Te=!0),b!==!1){let P=L;P.auto(i,Fr)?la():Or(A,P.min,P.max),te=te||ue.left>=0,ge=!0,Gi()}}i.setData=aa;function la(){Fr=!0;let _,b;r==1&&(ni>0?(li=ir[0]=0,ci=ir[1]=ni-1,_=e[0][li],b=e[0][ci],z==2?(_=li,b=ci):_==b&&(z==3?[_,b]=uc(_,_,L.log,!1):z==4?[_,b]=Ah(_,_,L.log,!1):L.time?b=_+Mi(86400/g):[_,b]=ac(_,b,Rh,!0))):(li=ir[0]=_=null,ci=ir[1]=b=null)),Or(A,_,b)}let Os,Ur,Bs,E,k,J,Y,$,Pe,Ue;function Le(_,b,P,F,V,Z){_??=vp,P??=Ph,F??="butt",V??=vp,Z??="round",_!=Os&&(h.strokeStyle=Os=_),V!=Ur&&(h.fillStyle=Ur=V),b!=Bs&&(h.lineWidth=Bs=b),Z!=k&&(h.lineJoin=k=Z),F!=J&&(h.lineCap=J=F),P!=E&&h.setLineDash(E=P)}function Oe(_,b,P,F){b!=Ur&&(h.fillStyle=Ur=b),_!=Y&&(h.font=Y=_),P!=$&&(h.textAlign=$=P),F!=Pe&&(h.textBaseline=Pe=F)}function Ze(_,b,P,F,V=0){if(F.length>0&&_.auto(i,Fr)&&(b==null||b.min==null)){let Z=Dt(li,0),ae=Dt(ci,F.length-1),me=P.min==null?MM(F,Z,ae,V,_.distr==3):[P.min,P.max];_.min=Wn(_.min,P.min=me[0]),_.max=ji(_.max,P.max=me[1])}}let ft={min:null,max:null};function wt(){for(let F in y){let V=y[F];H[F]==null&&(V.min==null||H[A]!=null&&V.auto(i,Fr))&&(H[F]=ft)}for(let F in y){let V=y[F];H[F]==null&&V.from!=null&&H[V.from]!=null&&(H[F]=ft)}H[A]!=null&&St(!0);let _={};for(let F in H){let V=H[F];if(V!=null){let Z=_[F]=to(y[F],CM);if(V.min!=null)gi(Z,V);else if(F!=A||r==2)if(ni==0&&Z.from==null){let ae=Z.range(i,null,null,F);Z.min=ae[0],Z.max=ae[1]}else Z.min=Vt,Z.max=-Vt}}if(ni>0){v.forEach((F,V)=>{if(r==1){let Z=F.scale,ae=H[Z];if(ae==null)return;let me=_[Z];if(V==0){let Ae=me.range(i,me.min,me.max,Z);me.min=Ae[0],me.max=Ae[1],li=Vn(me.min,e[0]),ci=Vn(me.max,e[0]),ci-li>1&&(e[0][li]<me.min&&li++,e[0][ci]>me.max&&ci--),F.min=sn[li],F.max=sn[ci]}else F.show&&F.auto&&Ze(me,ae,F,e[V],F.sorted);F.idxs[0]=li,F.idxs[1]=ci}else if(V>0&&F.show&&F.auto){let[Z,ae]=F.facets,me=Z.scale,Ae=ae.scale,[ze,Ge]=e[V],We=_[me],dt=_[Ae];We!=null&&Ze(We,H[me],Z,ze,Z.sorted),dt!=null&&Ze(dt,H[Ae],ae,Ge,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in _){let V=_[F],Z=H[F];if(V.from==null&&(Z==null||Z.min==null)){let ae=V.range(i,V.min==Vt?null:V.min,V.max==-Vt?null:V.max,F);V.min=ae[0],V.max=ae[1]}}}for(let F in _){let V=_[F];if(V.from!=null){let Z=_[V.from];if(Z.min==null)V.min=V.max=null;else{let ae=V.range(i,Z.min,Z.max,F);V.min=ae[0],V.max=ae[1]}}}let b={},P=!1;for(let F in _){let V=_[F],Z=y[F];if(Z.min!=V.min||Z.max!=V.max){Z.min=V.min,Z.max=V.max;let ae=Z.distr;Z._min=ae==3?br(Z.min):ae==4?uh(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?br(Z.max):ae==4?uh(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,b[F]=P=!0}}if(P){v.forEach((F,V)=>{r==2?V>0&&b.y&&(F._paths=null):b[F.scale]&&(F._paths=null)});for(let F in b)Te=!0,Ci("setScale",F);xe&&ue.left>=0&&(te=ge=!0)}for(let F in H)H[F]=null}function $e(_){let b=_h(li-1,0,ni-1),P=_h(ci+1,0,ni-1);for(;_[b]==null&&b>0;)b--;for(;_[P]==null&&P<ni-1;)P++;return[b,P]}function Et(){if(ni>0){let _=v.some(b=>b._focus)&&Ue!=Ye.alpha;_&&(h.globalAlpha=Ue=Ye.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(jt(P,!1),jt(P,!0),b._paths==null)){let F=Ue;Ue!=b.alpha&&(h.globalAlpha=Ue=b.alpha);let V=r==2?[0,e[P][0].length-1]:$e(e[P]);b._paths=b.paths(i,P,V[0],V[1]),Ue!=F&&(h.globalAlpha=Ue=F)}}),v.forEach((b,P)=>{if(P>0&&b.show){let F=Ue;Ue!=b.alpha&&(h.globalAlpha=Ue=b.alpha),b._paths!=null&&Bt(P,!1);{let V=b._paths!=null?b._paths.gaps:null,Z=b.points.show(i,P,li,ci,V),ae=b.points.filter(i,P,Z,V);(Z||ae)&&(b.points._paths=b.points.paths(i,P,li,ci,ae),Bt(P,!0))}Ue!=F&&(h.globalAlpha=Ue=F),Ci("drawSeries",P)}}),_&&(h.globalAlpha=Ue=1)}}function jt(_,b){let P=b?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Bt(_,b){let P=b?v[_].points:v[_],{stroke:F,fill:V,clip:Z,flags:ae,_stroke:me=P._stroke,_fill:Ae=P._fill,_width:ze=P.width}=P._paths;ze=Wt(ze*Ut,3);let Ge=null,We=ze%2/2;b&&Ae==null&&(Ae=ze>0?"#fff":me);let dt=P.pxAlign==1&&We>0;if(dt&&h.translate(We,We),!b){let Ft=R-ze/2,Lt=S-ze/2,Tt=X+ze,lt=pe+ze;Ge=new Path2D,Ge.rect(Ft,Lt,Tt,lt)}b?Ve(me,ze,P.dash,P.cap,Ae,F,V,ae,Z):kt(_,me,ze,P.dash,P.cap,Ae,F,V,ae,Ge,Z),dt&&h.translate(-We,-We)}function kt(_,b,P,F,V,Z,ae,me,Ae,ze,Ge){let We=!1;Ae!=0&&C.forEach((dt,Ft)=>{if(dt.series[0]==_){let Lt=v[dt.series[1]],Tt=e[dt.series[1]],lt=(Lt._paths||ya).band;Vr(lt)&&(lt=dt.dir==1?lt[0]:lt[1]);let je,$t=null;Lt.show&&lt&&SM(Tt,li,ci)?($t=dt.fill(i,Ft)||Z,je=Lt._paths.clip):lt=null,Ve(b,P,F,V,$t,ae,me,Ae,ze,Ge,je,lt),We=!0}}),We||Ve(b,P,F,V,Z,ae,me,Ae,ze,Ge)}let vi=io|yh;function Ve(_,b,P,F,V,Z,ae,me,Ae,ze,Ge,We){Le(_,b,P,F,V),(Ae||ze||We)&&(h.save(),Ae&&h.clip(Ae),ze&&h.clip(ze)),We?(me&vi)==vi?(h.clip(We),Ge&&h.clip(Ge),Rt(V,ae),fi(_,Z,b)):me&yh?(Rt(V,ae),h.clip(We),fi(_,Z,b)):me&io&&(h.save(),h.clip(We),Ge&&h.clip(Ge),Rt(V,ae),h.restore(),fi(_,Z,b)):(Rt(V,ae),fi(_,Z,b)),(Ae||ze||We)&&h.restore()}function fi(_,b,P){P>0&&(b instanceof Map?b.forEach((F,V)=>{h.strokeStyle=Os=V,h.stroke(F)}):b!=null&&_&&h.stroke(b))}function Rt(_,b){b instanceof Map?b.forEach((P,F)=>{h.fillStyle=Ur=F,h.fill(P)}):b!=null&&_&&h.fill(b)}function _r(_,b,P,F){let V=T[_],Z;if(F<=0)Z=[0,0];else{let ae=V._space=V.space(i,_,b,P,F),me=V._incrs=V.incrs(i,_,b,P,F,ae);Z=Vy(b,P,me,F,ae)}return V._found=Z}function pi(_,b,P,F,V,Z,ae,me,Ae,ze){let Ge=ae%2/2;M==1&&h.translate(Ge,Ge),Le(me,ae,Ae,ze,me),h.beginPath();let We,dt,Ft,Lt,Tt=V+(F==0||F==3?-Z:Z);P==0?(dt=V,Lt=Tt):(We=V,Ft=Tt);for(let lt=0;lt<_.length;lt++)b[lt]!=null&&(P==0?We=Ft=_[lt]:dt=Lt=_[lt],h.moveTo(We,dt),h.lineTo(Ft,Lt));h.stroke(),M==1&&h.translate(-Ge,-Ge)}function ks(_){let b=!0;return T.forEach((P,F)=>{if(!P.show)return;let V=y[P.scale];if(V.min==null){P._show&&(b=!1,P._show=!1,St(!1));return}else P._show||(b=!1,P._show=!0,St(!1));let Z=P.side,ae=Z%2,{min:me,max:Ae}=V,[ze,Ge]=_r(F,me,Ae,ae==0?U:Se);if(Ge==0)return;let We=V.distr==2,dt=P._splits=P.splits(i,F,me,Ae,ze,Ge,We),Ft=V.distr==2?dt.map(je=>sn[je]):dt,Lt=V.distr==2?sn[dt[1]]-sn[dt[0]]:ze,Tt=P._values=P.values(i,P.filter(i,Ft,F,Ge,Lt),F,Ge,Lt);P._rotate=Z==2?P.rotate(i,Tt,F,Ge):0;let lt=P._size;P._size=An(P.size(i,Tt,F,_)),lt!=null&&P._size!=lt&&(b=!1)}),b}function nr(_){let b=!0;return oa.forEach((P,F)=>{let V=P(i,F,tr,_);V!=Bn[F]&&(b=!1),Bn[F]=V}),b}function vr(){for(let _=0;_<T.length;_++){let b=T[_];if(!b.show||!b._show)continue;let P=b.side,F=P%2,V,Z,ae=b.stroke(i,_),me=P==0||P==3?-1:1,[Ae,ze]=b._found;if(b.label!=null){let Zi=b.labelGap*me,ln=Mi((b._lpos+Zi)*Ut);Oe(b.labelFont[0],ae,"center",P==2?"top":_p),h.save(),F==1?(V=Z=0,h.translate(ln,Mi(S+pe/2)),h.rotate((P==3?-sc:sc)/2)):(V=Mi(R+X/2),Z=ln);let fs=ad(b.label)?b.label(i,_,Ae,ze):b.label;h.fillText(fs,V,Z),h.restore()}if(ze==0)continue;let Ge=y[b.scale],We=F==0?X:pe,dt=F==0?R:S,Ft=b._splits,Lt=Ge.distr==2?Ft.map(Zi=>sn[Zi]):Ft,Tt=Ge.distr==2?sn[Ft[1]]-sn[Ft[0]]:Ae,lt=b.ticks,je=b.border,$t=lt.show?lt.size:0,si=Mi($t*Ut),Pi=Mi((b.alignTo==2?b._size-$t-b.gap:b.gap)*Ut),Ht=b._rotate*-sc/180,oi=d(b._pos*Ut),on=(si+Pi)*me,Ki=oi+on;Z=F==0?Ki:0,V=F==1?Ki:0;let wn=b.font[0],kn=b.align==1?Zs:b.align==2?ah:Ht>0?Zs:Ht<0?ah:F==0?"center":P==3?ah:Zs,or=Ht||F==1?"middle":P==2?"top":_p;Oe(wn,ae,kn,or);let an=b.font[1]*b.lineGap,En=Ft.map(Zi=>d(a(Zi,Ge,We,dt))),zn=b._values;for(let Zi=0;Zi<zn.length;Zi++){let ln=zn[Zi];if(ln!=null){F==0?V=En[Zi]:Z=En[Zi],ln=""+ln;let fs=ln.indexOf(`
`)==-1?[ln]:ln.split(/\n/gm);for(let Ji=0;Ji<fs.length;Ji++){let ip=fs[Ji];Ht?(h.save(),h.translate(V,Z+Ji*an),h.rotate(Ht),h.fillText(ip,0,0),h.restore()):h.fillText(ip,V,Z+Ji*an)}}}lt.show&&pi(En,lt.filter(i,Lt,_,ze,Tt),F,P,oi,si,Wt(lt.width*Ut,3),lt.stroke(i,_),lt.dash,lt.cap);let ar=b.grid;ar.show&&pi(En,ar.filter(i,Lt,_,ze,Tt),F,F==0?2:1,F==0?S:R,F==0?pe:X,Wt(ar.width*Ut,3),ar.stroke(i,_),ar.dash,ar.cap),je.show&&pi([oi],[1],F==0?1:0,F==0?1:2,F==1?S:R,F==1?pe:X,Wt(je.width*Ut,3),je.stroke(i,_),je.dash,je.cap)}Ci("drawAxes")}function St(_){v.forEach((b,P)=>{P>0&&(b._paths=null,_&&(r==1?(b.min=null,b.max=null):b.facets.forEach(F=>{F.min=null,F.max=null})))})}let ri=!1,$i=!1,zt=[];function di(){$i=!1;for(let _=0;_<zt.length;_++)Ci(...zt[_]);zt.length=0}function Gi(){ri||(NM(Bf),ri=!0)}function Nl(_,b=!1){ri=!0,$i=b,_(i),Bf(),b&&zt.length>0&&queueMicrotask(di)}i.batch=Nl;function Bf(){if(oe&&(wt(),oe=!1),Te&&(Ce(),Te=!1),be){if(Kt(p,Zs,qe),Kt(p,"top",ht),Kt(p,xa,U),Kt(p,_a,Se),Kt(m,Zs,qe),Kt(m,"top",ht),Kt(m,xa,U),Kt(m,_a,Se),Kt(f,xa,pt),Kt(f,_a,yt),u.width=Mi(pt*Ut),u.height=Mi(yt*Ut),T.forEach(({_el:_,_show:b,_size:P,_pos:F,side:V})=>{if(_!=null)if(b){let Z=V===3||V===0?P:0,ae=V%2==1;Kt(_,ae?"left":"top",F-Z),Kt(_,ae?"width":"height",P),Kt(_,ae?"top":"left",ae?ht:qe),Kt(_,ae?"height":"width",ae?Se:U),gh(_,xs)}else hn(_,xs)}),Os=Ur=Bs=k=J=Y=$=Pe=E=null,Ue=1,ha(!0),qe!=Ee||ht!=Nt||U!=Ke||Se!=it){St(!1);let _=U/Ke,b=Se/it;if(xe&&!te&&ue.left>=0){ue.left*=_,ue.top*=b,zs&&cr(zs,Mi(ue.left),0,U,Se),Gs&&cr(Gs,0,Mi(ue.top),U,Se);for(let P=0;P<Mt.length;P++){let F=Mt[P];F!=null&&(Xt[P]*=_,Yi[P]*=b,cr(F,An(Xt[P]),An(Yi[P]),U,Se))}}if(Yt.show&&!ne&&Yt.left>=0&&Yt.width>0){Yt.left*=_,Yt.width*=_,Yt.top*=b,Yt.height*=b;for(let P in ju)Kt(Ws,P,Yt[P])}Ee=qe,Nt=ht,Ke=U,it=Se}Ci("setSize"),be=!1}pt>0&&yt>0&&(h.clearRect(0,0,u.width,u.height),Ci("drawClear"),w.forEach(_=>_()),Ci("draw")),Yt.show&&ne&&(Ol(Yt),ne=!1),xe&&te&&(hs(null,!0,!1),te=!1),de.show&&de.live&&ge&&(Ju(),ge=!1),l||(l=!0,i.status=1,Ci("ready")),Fr=!1,ri=!1}i.redraw=(_,b)=>{Te=b||!1,_!==!1?Or(A,L.min,L.max):Gi()};function $u(_,b){let P=y[_];if(P.from==null){if(ni==0){let F=P.range(i,b.min,b.max,_);b.min=F[0],b.max=F[1]}if(b.min>b.max){let F=b.min;b.min=b.max,b.max=F}if(ni>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==A&&P.distr==2&&ni>0&&(b.min=Vn(b.min,e[0]),b.max=Vn(b.max,e[0]),b.min==b.max&&b.max++),H[_]=b,oe=!0,Gi()}}i.setScale=$u;let Ku,Zu,zs,Gs,kf,zf,Hs,Vs,Gf,Hf,qt,Zt,Nr=!1,Ni=ue.drag,Ai=Ni.x,Ri=Ni.y;xe&&(ue.x&&(Ku=Tn(oM,m)),ue.y&&(Zu=Tn(aM,m)),L.ori==0?(zs=Ku,Gs=Zu):(zs=Zu,Gs=Ku),qt=ue.left,Zt=ue.top);let Yt=i.select=gi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ws=Yt.show?Tn(sM,Yt.over?m:p):null;function Ol(_,b){if(Yt.show){for(let P in _)Yt[P]=_[P],P in ju&&Kt(Ws,P,_[P]);b!==!1&&Ci("setSelect")}}i.setSelect=Ol;function dv(_){if(v[_].show)j&&gh(ot[_],xs);else if(j&&hn(ot[_],xs),xe){let P=Fe?Mt[0]:Mt[_];P!=null&&cr(P,-10,-10,U,Se)}}function Or(_,b,P){$u(_,{min:b,max:P})}function rr(_,b,P,F){b.focus!=null&&vv(_),b.show!=null&&v.forEach((V,Z)=>{Z>0&&(_==Z||_==null)&&(V.show=b.show,dv(Z),r==2?(Or(V.facets[0].scale,null,null),Or(V.facets[1].scale,null,null)):Or(V.scale,null,null),Gi())}),P!==!1&&Ci("setSeries",_,b),F&&fa("setSeries",i,_,b)}i.setSeries=rr;function mv(_,b){gi(C[_],b)}function gv(_,b){_.fill=Ct(_.fill||null),_.dir=Dt(_.dir,-1),b=b??C.length,C.splice(b,0,_)}function xv(_){_==null?C.length=0:C.splice(_,1)}i.addBand=gv,i.setBand=mv,i.delBand=xv;function _v(_,b){v[_].alpha=b,xe&&Mt[_]!=null&&(Mt[_].style.opacity=b),j&&ot[_]&&(ot[_].style.opacity=b)}let Mr,Br,us,Xs={focus:!0};function vv(_){if(_!=us){let b=_==null,P=Ye.alpha!=1;v.forEach((F,V)=>{if(r==1||V>0){let Z=b||V==0||V==_;F._focus=b?null:Z,P&&_v(V,Z?1:Ye.alpha)}}),us=_,P&&Gi()}}j&&ut&&ke(Sp,De,_=>{ue._lock||(ct(_),us!=null&&rr(null,Xs,!0,mi.setSeries))});function sr(_,b,P){let F=y[b];P&&(_=_/Ut-(F.ori==1?ht:qe));let V=U;F.ori==1&&(V=Se,_=V-_),F.dir==-1&&(_=V-_);let Z=F._min,ae=F._max,me=_/V,Ae=Z+(ae-Z)*me,ze=F.distr;return ze==3?js(10,Ae):ze==4?wM(Ae,F.asinh):ze==100?F.bwd(Ae):Ae}function Mv(_,b){let P=sr(_,A,b);return Vn(P,e[0],li,ci)}i.valToIdx=_=>Vn(_,e[0]),i.posToIdx=Mv,i.posToVal=sr,i.valToPos=(_,b,P)=>y[b].ori==0?s(_,y[b],P?X:U,P?R:0):o(_,y[b],P?pe:Se,P?S:0),i.setCursor=(_,b,P)=>{qt=_.left,Zt=_.top,hs(null,b,P)};function Vf(_,b){Kt(Ws,Zs,Yt.left=_),Kt(Ws,xa,Yt.width=b)}function Wf(_,b){Kt(Ws,"top",Yt.top=_),Kt(Ws,_a,Yt.height=b)}let ca=L.ori==0?Vf:Wf,ua=L.ori==1?Vf:Wf;function yv(){if(j&&de.live)for(let _=r==2?1:0;_<v.length;_++){if(_==0&&rt)continue;let b=de.values[_],P=0;for(let F in b)Je[_][P++].firstChild.nodeValue=b[F]}}function Ju(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((P,F)=>{ee[F]=P}):RM(_.idx)||ee.fill(_.idx),de.idx=ee[0]),j&&de.live){for(let P=0;P<v.length;P++)(P>0||r==1&&!rt)&&Sv(P,ee[P]);yv()}ge=!1,b!==!1&&Ci("setLegend")}i.setLegend=Ju;function Sv(_,b){let P=v[_],F=_==0&&z==2?sn:e[_],V;rt?V=P.values(i,_,b)??se:(V=P.value(i,b==null?null:F[b],_,b),V=V==null?se:{_:V}),de.values[_]=V}function hs(_,b,P){Gf=qt,Hf=Zt,[qt,Zt]=ue.move(i,qt,Zt),ue.left=qt,ue.top=Zt,xe&&(zs&&cr(zs,Mi(qt),0,U,Se),Gs&&cr(Gs,0,Mi(Zt),U,Se));let F,V=li>ci;Mr=Vt,Br=null;let Z=L.ori==0?U:Se,ae=L.ori==1?U:Se;if(qt<0||ni==0||V){F=ue.idx=null;for(let me=0;me<v.length;me++){let Ae=Mt[me];Ae!=null&&cr(Ae,-10,-10,U,Se)}ut&&rr(null,Xs,!0,_==null&&mi.setSeries),de.live&&(ee.fill(F),ge=!0)}else{let me,Ae,ze;r==1&&(me=L.ori==0?qt:Zt,Ae=sr(me,A),F=ue.idx=Vn(Ae,e[0],li,ci),ze=W(e[0][F],L,Z,0));let Ge=-10,We=-10,dt=0,Ft=0,Lt=!0,Tt="",lt="";for(let je=r==2?1:0;je<v.length;je++){let $t=v[je],si=ee[je],Pi=si==null?null:r==1?e[je][si]:e[je][1][si],Ht=ue.dataIdx(i,je,F,Ae),oi=Ht==null?null:r==1?e[je][Ht]:e[je][1][Ht];if(ge=ge||oi!=Pi||Ht!=si,ee[je]=Ht,je>0&&$t.show){let on=Ht==null?-10:Ht==F?ze:W(r==1?e[0][Ht]:e[je][0][Ht],L,Z,0),Ki=oi==null?-10:I(oi,r==1?y[$t.scale]:y[$t.facets[1].scale],ae,0);if(ut&&oi!=null){let wn=L.ori==1?qt:Zt,kn=yi(Ye.dist(i,je,Ht,Ki,wn));if(kn<Mr){let or=Ye.bias;if(or!=0){let an=sr(wn,$t.scale),En=oi>=0?1:-1,zn=an>=0?1:-1;zn==En&&(zn==1?or==1?oi>=an:oi<=an:or==1?oi<=an:oi>=an)&&(Mr=kn,Br=je)}else Mr=kn,Br=je}}if(ge||Fe){let wn,kn;L.ori==0?(wn=on,kn=Ki):(wn=Ki,kn=on);let or,an,En,zn,ar,Zi,ln=!0,fs=fe.bbox;if(fs!=null){ln=!1;let Ji=fs(i,je);En=Ji.left,zn=Ji.top,or=Ji.width,an=Ji.height}else En=wn,zn=kn,or=an=fe.size(i,je);if(Zi=fe.fill(i,je),ar=fe.stroke(i,je),Fe)je==Br&&Mr<=Ye.prox&&(Ge=En,We=zn,dt=or,Ft=an,Lt=ln,Tt=Zi,lt=ar);else{let Ji=Mt[je];Ji!=null&&(Xt[je]=En,Yi[je]=zn,Cp(Ji,or,an,ln),Ap(Ji,Zi,ar),cr(Ji,An(En),An(zn),U,Se))}}}}if(Fe){let je=Ye.prox,$t=us==null?Mr<=je:Mr>je||Br!=us;if(ge||$t){let si=Mt[0];si!=null&&(Xt[0]=Ge,Yi[0]=We,Cp(si,dt,Ft,Lt),Ap(si,Tt,lt),cr(si,An(Ge),An(We),U,Se))}}}if(Yt.show&&Nr)if(_!=null){let[me,Ae]=mi.scales,[ze,Ge]=mi.match,[We,dt]=_.cursor.sync.scales,Ft=_.cursor.drag;if(Ai=Ft._x,Ri=Ft._y,Ai||Ri){let{left:Lt,top:Tt,width:lt,height:je}=_.select,$t=_.scales[We].ori,si=_.posToVal,Pi,Ht,oi,on,Ki,wn=me!=null&&ze(me,We),kn=Ae!=null&&Ge(Ae,dt);wn&&Ai?($t==0?(Pi=Lt,Ht=lt):(Pi=Tt,Ht=je),oi=y[me],on=W(si(Pi,We),oi,Z,0),Ki=W(si(Pi+Ht,We),oi,Z,0),ca(Wn(on,Ki),yi(Ki-on))):ca(0,Z),kn&&Ri?($t==1?(Pi=Lt,Ht=lt):(Pi=Tt,Ht=je),oi=y[Ae],on=I(si(Pi,dt),oi,ae,0),Ki=I(si(Pi+Ht,dt),oi,ae,0),ua(Wn(on,Ki),yi(Ki-on))):ua(0,ae)}else eh()}else{let me=yi(Gf-kf),Ae=yi(Hf-zf);if(L.ori==1){let dt=me;me=Ae,Ae=dt}Ai=Ni.x&&me>=Ni.dist,Ri=Ni.y&&Ae>=Ni.dist;let ze=Ni.uni;ze!=null?Ai&&Ri&&(Ai=me>=ze,Ri=Ae>=ze,!Ai&&!Ri&&(Ae>me?Ri=!0:Ai=!0)):Ni.x&&Ni.y&&(Ai||Ri)&&(Ai=Ri=!0);let Ge,We;Ai&&(L.ori==0?(Ge=Hs,We=qt):(Ge=Vs,We=Zt),ca(Wn(Ge,We),yi(We-Ge)),Ri||ua(0,ae)),Ri&&(L.ori==1?(Ge=Hs,We=qt):(Ge=Vs,We=Zt),ua(Wn(Ge,We),yi(We-Ge)),Ai||ca(0,Z)),!Ai&&!Ri&&(ca(0,0),ua(0,0))}if(Ni._x=Ai,Ni._y=Ri,_==null){if(P){if(tp!=null){let[me,Ae]=mi.scales;mi.values[0]=me!=null?sr(L.ori==0?qt:Zt,me):null,mi.values[1]=Ae!=null?sr(L.ori==1?qt:Zt,Ae):null}fa(lh,i,qt,Zt,U,Se,F)}if(ut){let me=P&&mi.setSeries,Ae=Ye.prox;us==null?Mr<=Ae&&rr(Br,Xs,!0,me):Mr>Ae?rr(null,Xs,!0,me):Br!=us&&rr(Br,Xs,!0,me)}}ge&&(de.idx=F,Ju()),b!==!1&&Ci("setCursor")}let kr=null;Object.defineProperty(i,"rect",{get(){return kr==null&&ha(!1),kr}});function ha(_=!1){_?kr=null:(kr=m.getBoundingClientRect(),Ci("syncRect",kr))}function Xf(_,b,P,F,V,Z,ae){ue._lock||Nr&&_!=null&&_.movementX==0&&_.movementY==0||(Qu(_,b,P,F,V,Z,ae,!1,_!=null),_!=null?hs(null,!0,!0):hs(b,!0,!1))}function Qu(_,b,P,F,V,Z,ae,me,Ae){if(kr==null&&ha(!1),ct(_),_!=null)P=_.clientX-kr.left,F=_.clientY-kr.top;else{if(P<0||F<0){qt=-10,Zt=-10;return}let[ze,Ge]=mi.scales,We=b.cursor.sync,[dt,Ft]=We.values,[Lt,Tt]=We.scales,[lt,je]=mi.match,$t=b.axes[0].side%2==1,si=L.ori==0?U:Se,Pi=L.ori==1?U:Se,Ht=$t?Z:V,oi=$t?V:Z,on=$t?F:P,Ki=$t?P:F;if(Lt!=null?P=lt(ze,Lt)?a(dt,y[ze],si,0):-10:P=si*(on/Ht),Tt!=null?F=je(Ge,Tt)?a(Ft,y[Ge],Pi,0):-10:F=Pi*(Ki/oi),L.ori==1){let wn=P;P=F,F=wn}}Ae&&(b==null||b.cursor.event.type==lh)&&((P<=1||P>=U-1)&&(P=ms(P,U)),(F<=1||F>=Se-1)&&(F=ms(F,Se))),me?(kf=P,zf=F,[Hs,Vs]=ue.move(i,P,F)):(qt=P,Zt=F)}let ju={width:0,height:0,left:0,top:0};function eh(){Ol(ju,!1)}let qf,Yf,$f,Kf;function Zf(_,b,P,F,V,Z,ae){Nr=!0,Ai=Ri=Ni._x=Ni._y=!1,Qu(_,b,P,F,V,Z,ae,!0,!1),_!=null&&(ke(ch,dh,Jf,!1),fa(Mp,i,Hs,Vs,U,Se,null));let{left:me,top:Ae,width:ze,height:Ge}=Yt;qf=me,Yf=Ae,$f=ze,Kf=Ge}function Jf(_,b,P,F,V,Z,ae){Nr=Ni._x=Ni._y=!1,Qu(_,b,P,F,V,Z,ae,!1,!0);let{left:me,top:Ae,width:ze,height:Ge}=Yt,We=ze>0||Ge>0,dt=qf!=me||Yf!=Ae||$f!=ze||Kf!=Ge;if(We&&dt&&Ol(Yt),Ni.setScale&&We&&dt){let Ft=me,Lt=ze,Tt=Ae,lt=Ge;if(L.ori==1&&(Ft=Ae,Lt=Ge,Tt=me,lt=ze),Ai&&Or(A,sr(Ft,A),sr(Ft+Lt,A)),Ri)for(let je in y){let $t=y[je];je!=A&&$t.from==null&&$t.min!=Vt&&Or(je,sr(Tt+lt,je),sr(Tt,je))}eh()}else ue.lock&&(ue._lock=!ue._lock,hs(b,!0,_!=null));_!=null&&(gt(ch,dh),fa(ch,i,qt,Zt,U,Se,null))}function bv(_,b,P,F,V,Z,ae){if(ue._lock)return;ct(_);let me=Nr;if(Nr){let Ae=!0,ze=!0,Ge=10,We,dt;L.ori==0?(We=Ai,dt=Ri):(We=Ri,dt=Ai),We&&dt&&(Ae=qt<=Ge||qt>=U-Ge,ze=Zt<=Ge||Zt>=Se-Ge),We&&Ae&&(qt=qt<Hs?0:U),dt&&ze&&(Zt=Zt<Vs?0:Se),hs(null,!0,!0),Nr=!1}qt=-10,Zt=-10,ee.fill(null),hs(null,!0,!0),me&&(Nr=me)}function Qf(_,b,P,F,V,Z,ae){ue._lock||(ct(_),la(),eh(),_!=null&&fa(bp,i,qt,Zt,U,Se,null))}function jf(){T.forEach(Wy),N(i.width,i.height,!0)}_s(oc,Qs,jf);let qs={};qs.mousedown=Zf,qs.mousemove=Xf,qs.mouseup=Jf,qs.dblclick=Qf,qs.setSeries=(_,b,P,F)=>{let V=mi.match[2];P=V(i,b,P),P!=-1&&rr(P,F,!0,!1)},xe&&(ke(Mp,m,Zf),ke(lh,m,Xf),ke(yp,m,_=>{ct(_),ha(!1)}),ke(Sp,m,bv),ke(bp,m,Qf),Sh.add(i),i.syncRect=ha);let Bl=i.hooks=n.hooks||{};function Ci(_,b,P){$i?zt.push([_,b,P]):_ in Bl&&Bl[_].forEach(F=>{F.call(null,i,b,P)})}(n.plugins||[]).forEach(_=>{for(let b in _.hooks)Bl[b]=(Bl[b]||[]).concat(_.hooks[b])});let ep=(_,b,P)=>P,mi=gi({key:null,setSeries:!1,filters:{pub:Fp,sub:Fp},scales:[A,v[1]?v[1].scale:null],match:[Up,Up,ep],values:[null,null]},ue.sync);mi.match.length==2&&mi.match.push(ep),ue.sync=mi;let tp=mi.key,th=Ld(tp);function fa(_,b,P,F,V,Z,ae){mi.filters.pub(_,b,P,F,V,Z,ae)&&th.pub(_,b,P,F,V,Z,ae)}th.sub(i);function wv(_,b,P,F,V,Z,ae){mi.filters.sub(_,b,P,F,V,Z,ae)&&qs[_](null,b,P,F,V,Z,ae)}i.pub=wv;function Ev(){th.unsub(i),Sh.delete(i),nt.clear(),xh(oc,Qs,jf),c.remove(),De?.remove(),Ci("destroy")}i.destroy=Ev;function ih(){Ci("init",n,e),aa(e||n.data,!1),H[A]?$u(A,H[A]):la(),ne=Yt.show&&(Yt.width>0||Yt.height>0),te=ge=!0,N(n.width,n.height)}return v.forEach(Ns),T.forEach(gr),t?t instanceof HTMLElement?(t.appendChild(c),ih()):t(i,ih):ih(),i}Bi.assign=gi;Bi.fmtNum=Ch;Bi.rangeNum=ac;Bi.rangeLog=uc;Bi.rangeAsinh=Ah;Bi.orient=Ms;Bi.pxRatio=Ut;Bi.join=UM;Bi.fmtDate=Lh,Bi.tzDate=qM;Bi.sync=Ld;{Bi.addGap=Ry,Bi.clipGaps=pc;let n=Bi.paths={points:Od};n.linear=kd,n.stepped=Ly,n.bars=Dy,n.spline=Fy}var Xy=6e5,[qy,Yy]=[60,600];function Vd(n,e,t){let i=Xy/Math.max(1,n.balls.length*e.length),r=Math.round(Math.min(Yy,Math.max(qy,i/2))),s=[...new Set(e.flatMap(l=>l.events.map(c=>c.at)))].filter(l=>l>0&&l<t).sort((l,c)=>l-c),o=Math.max(1,Math.ceil(2*s.length/Math.max(1,i-r))),a=[];for(let l=0;l<=r;l+=1)a.push([t*l/r,0]);for(let l=0;l<s.length;l+=o)a.push([s[l],1],[s[l],0]);return a.sort((l,c)=>l[0]-c[0]||c[1]-l[1]),{at:Float64Array.from(a,l=>l[0]),near:Uint8Array.from(a,l=>l[1])}}function Wd(n,e,t){let i=t.at.length,r=new Float64Array(i),s=new Float64Array(i),o=new Float64Array(i),a=Gn();n.balls.forEach((c,u)=>{let h=c.inertia/(n.R*n.R);for(let f=0;f<i;f+=1){let p=t.at[f],m=t.near[f]===1;if((m?p>e.leaves[u]:p>=e.leaves[u])||!e.paths[u]?.at(p,a,m))continue;let M=Bh(a.velocity);r[f]+=M,s[f]+=1,o[f]+=(c.mass*M+h*Bh(a.spin))/2}});let l=r.map((c,u)=>s[u]>0?Math.sqrt(c/s[u]):0);return{rms:kh(l,t,e.facts.end),energy:kh(o,t,e.facts.end)}}function Xd(n,e,t){let i=Gn(),r=Float64Array.from(t.at,(s,o)=>{let a=t.near[o]===1;return!(a?s>n.leaves[e]:s>=n.leaves[e])&&n.paths[e]?.at(s,i,a)?Math.sqrt(Bh(i.velocity)):NaN});return kh(r,t,n.facts.end)}function Bh(n){return n[0]*n[0]+n[1]*n[1]+n[2]*n[2]}function kh(n,e,t){let i=Math.fround(t)*1.000001,r=NaN;return n.map((s,o)=>e.at[o]<=i?(r=s,s):r===0?0:NaN)}function oo(n,e,t){let i=0,r=n.length;for(;i<r;){let a=i+r>>1;n[a]<=t?i=a+1:r=a}if(i===0)return NaN;let s=e[i-1]??NaN;if(i===n.length||t===n[i-1])return s;let o=e[i]??NaN;return s+(t-n[i-1])/(n[i]-n[i-1])*(o-s)}var qd=210,Yd=10,$d=11,ao=class{constructor(e,...t){this.facts=e;this.data=he("details",{},he("summary",{},"Data"),he("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":`${e.title}, data`},this.table)),this.data.addEventListener("toggle",()=>this.fill());let i=e.unit.length>Yd?[he("span",{class:"rp-unit"},`in ${e.unit}`)]:[];this.element=he("figure",{class:"rp-chart"},he("figcaption",{},he("b",{},e.title),...t,...i),this.host,this.values,this.data)}facts;element;host=he("div",{class:"rp-plot"});values=he("p",{class:"rp-values"});numbers=[];at=he("span",{});table=he("table",{});data;nowLine=he("div",{class:"rp-now-line"});future=he("div",{class:"rp-future"});plot=null;content={at:new Float64Array(0),lines:[]};time=0;told=-1/0;width=0;show(e){this.content=e;let t=e.lines.map(i=>he("span",{class:"rp-value"},Ks(i.run),he("span",{})));this.numbers.splice(0,1/0,...t.map(i=>i.lastElementChild)),this.values.replaceChildren(this.at,...t),this.build()}resize(e){Math.abs(e-this.width)>=1&&(this.width=e,this.plot?(this.plot.setSize({width:e,height:qd}),this.go(this.time,!1)):this.build())}go(e,t){this.time=e;let{plot:i}=this;if(!i)return;let r=i.valToPos(e,"x");this.nowLine.style.transform=`translateX(${r.toFixed(2)}px)`,this.facts.growing&&(this.future.style.left=`${r.toFixed(2)}px`);let s=performance.now();(!t||s-this.told>200)&&(this.told=s,this.tell())}build(){this.plot?.destroy(),this.plot=null;let{content:e,facts:t,host:i,width:r}=this;if(r<40||e.at.length===0)return;let s=getComputedStyle(this.element),o=t.unit.length>Yd,[a,l]=[s.getPropertyValue("--rp-soft").trim(),s.getPropertyValue("--rp-rule").trim()],c=`12px ${s.fontFamily}`,u={stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1,size:5},font:c,labelFont:c,labelSize:18},h=e.lines.flatMap(v=>Array.from(v.values).filter(T=>T>0)),f=h.reduce((v,T)=>Math.min(v,T),1/0),p=h.reduce((v,T)=>Math.max(v,T),0),m=(v,T)=>10**(T?Math.ceil(Math.log10(v)+.05):Math.floor(Math.log10(v))),M=t.log?[m(Math.max(f,1e-17),!1),m(Math.max(p,1e-16),!0)]:[0,p*1.16||1],d={width:r,height:qd,padding:[8,14,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5}},select:{show:!1,left:0,top:0,width:0,height:0},scales:{x:{time:!1,range:[0,t.end||1]},y:t.log?{distr:3,log:10,range:M}:{range:M}},axes:[{...u,label:`time, ${t.timeUnit}`,size:34},{...u,label:o?t.axis:`${t.axis}, ${t.unit}`,size:50,...t.log?{splits:()=>$y(M),filter:(v,T)=>T}:{},values:(v,T)=>T.map(y=>t.log?`1e${Math.round(Math.log10(y))}`.replace(/^1e0$/,"1"):ds(y))}],series:[{},...e.lines.map(v=>({label:v.label,stroke:rh(v.run),width:1.8,dash:cn(v.run).dash,points:{show:!1}}))],hooks:{draw:[v=>this.marks(v),v=>this.labels(v)]}},g=e.lines.map(v=>Array.from(v.values,T=>Number.isFinite(T)&&(!t.log||T>0)?T:null));this.plot=new Bi(d,[Array.from(e.at),...g],i),this.plot.over.append(this.nowLine),t.growing&&this.plot.over.append(this.future),this.hold(this.plot),this.go(this.time,!1),this.fill()}destroy(){this.plot?.destroy(),this.plot=null}hold(e){let{over:t}=e,i=r=>{let s=t.getBoundingClientRect();this.facts.seek(e.posToVal(r.clientX-s.left,"x"))};t.addEventListener("pointerdown",r=>{t.setPointerCapture(r.pointerId),i(r)}),t.addEventListener("pointermove",r=>{(r.buttons&1)!==0&&i(r)})}marks(e){let{ctx:t,bbox:i}=e,r=getComputedStyle(this.element),s=(o,a,l,c)=>{let u=e.valToPos(o,"x",!0);t.save(),t.strokeStyle=a,t.fillStyle=a,t.lineWidth=devicePixelRatio,t.setLineDash(l.map(p=>p*devicePixelRatio)),t.beginPath(),t.moveTo(u,i.top),t.lineTo(u,i.top+i.height),t.stroke(),t.font=`${10.5*devicePixelRatio}px ${r.fontFamily}`;let h=t.measureText(c).width,f=u+h+8*devicePixelRatio<i.left+i.width;t.textAlign=f?"left":"right",t.fillText(c,u+(f?4:-4)*devicePixelRatio,i.top+10*devicePixelRatio),t.restore()};this.facts.partings.length>0&&s(this.facts.partings[0],r.getPropertyValue("--rp-bad").trim(),[],"first divergence");for(let o of this.facts.partings.slice(1))s(o,r.getPropertyValue("--rp-bad").trim(),[2,3],"");this.facts.horizon!==null&&s(this.facts.horizon,r.getPropertyValue("--rp-soft").trim(),[6,3],"horizon")}labels(e){let{ctx:t,bbox:i}=e,{lines:r,at:s}=this.content;if(r.length<2)return;let o=devicePixelRatio,a=12*o;t.save(),t.font=`600 ${11*o}px ${getComputedStyle(this.element).fontFamily}`,t.textAlign="center";let l=[];r.forEach((c,u)=>{let h=t.measureText(c.label).width+6*o,f={x:0,y:0,room:0};for(let p=i.left+h/2+2*o;p<i.left+i.width-h/2;p+=i.width/60){let m=[-.5,-.25,0,.25,.5].map(x=>{let w=e.posToVal((p+x*h-i.left)/o,"x");return r.map(B=>e.valToPos(oo(s,B.values,w),"y",!0))}),M=m.map(x=>x[u]);if(!M.every(Number.isFinite))continue;let d=Math.min(...M)-5*o,g=d-a/3,v=m.flatMap(x=>x.filter((w,B)=>B!==u&&Number.isFinite(w))).map(x=>Math.abs(x-g)-a/2),T=m.flatMap(x=>x.filter((w,B)=>B!==u&&Number.isFinite(w)).map(w=>Math.abs(w-x[u])-9*o)),y=l.map(x=>Math.max(Math.abs(x.x-p)-(x.w+h)/2,Math.abs(x.y-d)-a)),C=Math.max(...M)-Math.min(...M),A=Math.min(40*o,d-a-i.top-12*o,...v,...T,...y)-.6*C;A>f.room&&(f={x:p,y:d,room:A})}f.room>0&&(t.fillStyle=rh(c.run),t.fillText(c.label,f.x,f.y),l.push({x:f.x,y:f.y,w:h}))}),t.restore()}tell(){let{content:e,facts:t}=this;en(this.at,e.lines.length>0?`${Oi(this.time,t.end)} ${t.timeUnit}:`:""),e.lines.forEach((i,r)=>en(this.numbers[r],`${i.label} ${ds(oo(e.at,i.values,this.time))}`)),this.data.open&&this.fill()}fill(){if(!this.data.open)return;let{content:e,facts:t}=this,i=(a,l)=>he("tr",{},he("th",{scope:"row",class:"r"},l),...e.lines.map(c=>he("td",{class:"r"},ds(oo(e.at,c.values,a))))),r=Array.from({length:$d},(a,l)=>t.end*l/($d-1)),s=t.growing?r.filter(a=>a<=this.time):r,o=he("tr",{},he("th",{scope:"col",class:"r"},`time, ${t.timeUnit}`),...e.lines.map(a=>he("th",{scope:"col",class:"r"},a.label)));this.table.replaceChildren(he("caption",{},`${t.axis}, ${t.unit}`),he("thead",{},o),he("tbody",{},i(this.time,`now: ${Oi(this.time,t.end)}`),...s.map(a=>i(a,Oi(a,t.end)))))}};function $y([n,e]){let[t,i]=[Math.round(Math.log10(n)),Math.round(Math.log10(e))],r=Math.max(1,Math.ceil((i-t)/6)),s=[];for(let o=Math.ceil(t/r)*r;o<=i;o+=r)s.push(10**o);return s}var xc=class{constructor(e,t,i){this.stage=e;let{data:r,runs:s,end:o}=e,a=r.scene.time_unit,l=(c,u,h,f=!1)=>({title:c,axis:u,unit:h,log:f,growing:i,timeUnit:a,end:o,partings:r.partings.map(p=>p.time),horizon:r.horizon,seek:p=>t.seek(p)});this.ball=he("select",{"aria-label":"Speed of"},he("option",{value:-1},"all balls, rms"),...r.balls.map((c,u)=>he("option",{value:u},c.id==="cue"?"the cue ball":`ball ${c.id}`))),this.ball.addEventListener("change",()=>t.follow(Number(this.ball.value))),this.speed=new ao(l("Speed","speed",`${r.scene.length_unit}/${a}`),he("label",{}," of ",this.ball)),this.energy=new ao(l("Kinetic energy","energy","E0")),this.divergence=r.divergence.some(c=>c.points.some(([,u])=>u>0))?new ao(l("Distance between engines, worst ball","distance","R",!0)):null,this.when=Vd(r,s,o),this.initial=Ky(e);for(let c of this.charts())this.element.append(c.element);this.sizes=new ResizeObserver(c=>{for(let u of c)this.charts().find(h=>h.element===u.target)?.resize(Math.floor(u.contentRect.width))}),this.charts().forEach(c=>this.sizes.observe(c.element)),this.dark.addEventListener("change",this.recolour)}stage;element=he("div",{class:"rp-plots"});speed;energy;divergence;ball;when;made=new Map;sizes;dark=matchMedia("(prefers-color-scheme: dark)");choice=null;initial;choose(e){let t=this.choice,i=t!==null&&t.ball===e.ball&&t.solid===e.solid&&t.shown.join()===e.shown.join();if(this.choice={...e,shown:[...e.shown]},i)return;this.ball.value=String(e.ball);let{stage:r,when:s}=this,{data:o}=r,a=r.runs.filter(c=>e.shown[c.index]||c.index===e.solid),l=c=>({at:s.at,lines:a.map(u=>({label:u.facts.label,run:u.index,values:c(u.index)}))});this.speed.show(l(c=>(e.ball<0?this.curves(c).rms:Xd(r.runs[c],e.ball,s)).map(u=>u*o.R))),this.energy.show(l(c=>this.curves(c).energy.map(u=>this.initial>0?u/this.initial:u))),this.divergence?.show(this.pairs(e))}go(e,t){for(let i of this.charts())i.go(e,t)}destroy(){this.dark.removeEventListener("change",this.recolour),this.sizes.disconnect();for(let e of this.charts())e.destroy()}recolour=()=>this.charts().forEach(e=>e.build());charts(){return[this.speed,this.energy,...this.divergence?[this.divergence]:[]]}curves(e){let t=this.made.get(e);return t||(t=Wd(this.stage.data,this.stage.runs[e],this.when),this.made.set(e,t)),t}pairs(e){let{data:t}=this.stage,i=a=>e.shown[a]||a===e.solid,r=t.divergence.filter(a=>i(a.run)&&i(a.against)),s=Float64Array.from(new Set(r.flatMap(a=>a.points.map(([l])=>l)))).sort(),o=r.map(a=>{let[l,c]=[a.points.map(([f])=>f),a.points.map(([,f])=>f)],u=t.runs[a.run].label,h=t.runs[a.against];return{label:h.reference?u:`${u} to ${h.label}`,run:a.run,values:Float64Array.from(s,f=>f<=l[l.length-1]?oo(l,c,f):NaN)}});return{at:s,lines:o}}};function Ky(n){let{data:e,runs:t}=n,i=Gn();for(let r of t)if(r.paths.every(s=>s.count>0))return e.balls.reduce((s,o,a)=>{r.paths[a].at(0,i,!0);let l=i.velocity.reduce((u,h)=>u+h*h,0),c=i.spin.reduce((u,h)=>u+h*h,0);return s+(o.mass*l+o.inertia/e.R**2*c)/2},0);return 0}var Zy=250,_c=class{constructor(e){this.stage=e;let{balls:t,rotates:i,scene:r}=e.data,[s,o]=[r.length_unit,r.time_unit],a=[`x, ${s}`,`y, ${s}`,`speed, ${s}/${o}`,...i?[`spin, rad/${o}`]:[],"state"],l=he("tr",{},he("th",{scope:"col"},"ball"),...a.map(h=>he("th",{scope:"col",class:"r"},h))),c=t.map(h=>{let f=a.map(()=>he("td",{class:"r"}));return this.cells.push(f),he("tr",{"data-ball":h.id},he("th",{scope:"row"},h.id),...f)}),u=he("table",{},this.caption,he("thead",{},l),he("tbody",{},...c));this.element=he("details",{class:"rp-readout"},he("summary",{},"Where the balls are now"),he("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":"Where the balls are now"},u))}stage;element;caption=he("caption",{});cells=[];last=-1/0;tell(e,t,i){let r=performance.now();if(i&&(!this.element.open||r-this.last<Zy))return;this.last=r;let{data:s,end:o}=this.stage,a=e.scatters[t],l=sh(s.R,4);en(this.caption,`${a.run.facts.label} at ${Oi(e.time,o)} ${s.scene.time_unit}`),this.cells.forEach((c,u)=>{let h=g=>s.origin[g]+s.R*a.positions[3*u+g],f=g=>Math.hypot(g[3*u],g[3*u+1],g[3*u+2]),p=f(a.velocities)*s.R,m=f(a.spins),M=a.present[u]?p>0?"moves":m>0?"spins":"rests":"fallen";[h(0).toFixed(l),h(1).toFixed(l),ds(p,5),...s.rotates?[ds(m,5)]:[],M].forEach((g,v)=>en(c[v],g))})}};var Kd=0,zh=1,Zd=2;var lo=1,Jd=2,ys=3,Rn=0,ei=1,Si=2,ur=0,Xr=1,Gh=2,Hh=3,Vh=4,Qd=5;var qr=100,jd=101,em=102,tm=103,im=104,nm=200,rm=201,sm=202,om=203,vc=204,Mc=205,am=206,lm=207,cm=208,um=209,hm=210,fm=211,pm=212,dm=213,mm=214,ba=0,wa=1,Ea=2,Yr=3,Ta=4,Aa=5,Ra=6,Ca=7,co=0,gm=1,xm=2,dn=0,yc=1,Sc=2,bc=3,wc=4,Ec=5,Tc=6,uo=7;var Wh=300,hr=301,$r=302,Ac=303,Rc=304,Kr=1e3,tn=1001,Pa=1002,Jt=1003,_m=1004;var La=1005;var xi=1006,Cc=1007;var mn=1008;var ui=1009,Pc=1010,Lc=1011,Er=1012,ho=1013,Li=1014,bi=1015,Di=1016,fo=1017,po=1018,Xn=1020,Dc=35902,Ic=35899,Fc=1021,Uc=1022,Hi=1023,nn=1026,gn=1027,mo=1028,go=1029,xn=1030,xo=1031;var _o=1033,vo=33776,Mo=33777,yo=33778,So=33779,Da=35840,Ia=35841,Fa=35842,Ua=35843,Na=36196,Oa=37492,Ba=37496,ka=37488,za=37489,Ss=37490,Ga=37491,Ha=37808,Va=37809,Wa=37810,Xa=37811,qa=37812,Ya=37813,$a=37814,Ka=37815,Za=37816,Ja=37817,Qa=37818,ja=37819,el=37820,tl=37821,il=36492,nl=36494,rl=36495,sl=36283,ol=36284,bs=36285,al=36286;var vm=3200;var ll=0,Mm=1,Cn="",wi="srgb",ws="srgb-linear",Es="linear",Pt="srgb";var Nc=7680;var ym=519,Sm=512,bm=513,wm=514,Oc=515,Em=516,Tm=517,Bc=518,kc=519,Am=35044,Rm=35048;var Xh="300 es",ki=2e3,Tr=2001;function Pm(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function wo(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Lm(){let n=wo("canvas");return n.style.display="block",n}var Cm={},bo=null;function qh(...n){let e="THREE."+n.shift();bo?bo("log",e,...n):console.log(e,...n)}function Dm(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Xe(...n){n=Dm(n);let e="THREE."+n.shift();if(bo)bo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function bt(...n){n=Dm(n);let e="THREE."+n.shift();if(bo)bo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ts(...n){let e=n.join(" ");e in Cm||(Cm[e]=!0,Xe(...n))}function Im(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Fm={[ba]:ba,[Ea]:Ra,[Ta]:Ta,[Yr]:Aa,[wa]:wa,[Ra]:Ea,[Ca]:Ca,[Aa]:Yr};var Vi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Wi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var zc=Math.PI/180,cl=180/Math.PI;function Pn(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Wi[n&255]+Wi[n>>8&255]+Wi[n>>16&255]+Wi[n>>24&255]+"-"+Wi[e&255]+Wi[e>>8&255]+"-"+Wi[e>>16&15|64]+Wi[e>>24&255]+"-"+Wi[t&63|128]+Wi[t>>8&255]+"-"+Wi[t>>16&255]+Wi[t>>24&255]+Wi[i&255]+Wi[i>>8&255]+Wi[i>>16&255]+Wi[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function Um(n,e){return(n%e+e)%e}function Gc(n,e,t){return(1-t)*n+t*e}function Nm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Hc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Om(n,e){if(e.constructor===Float32Array)return n;let t=Hc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Bm(n,e){if(e.constructor===Float32Array)return n;let t=Hc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var le=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Ii=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],u=i[r+2],h=i[r+3],f=s[o+0],p=s[o+1],m=s[o+2],M=s[o+3];if(h!==M||l!==f||c!==p||u!==m){let d=l*f+c*p+u*m+h*M;d<0&&(f=-f,p=-p,m=-m,M=-M,d=-d);let g=1-a;if(d<.9995){let v=Math.acos(d),T=Math.sin(v);g=Math.sin(g*v)/T,a=Math.sin(a*v)/T,l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,h=h*g+M*a}else{l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,h=h*g+M*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],u=i[r+3],h=s[o],f=s[o+1],p=s[o+2],m=s[o+3];return e[t]=a*m+u*h+l*p-c*f,e[t+1]=l*m+u*f+c*h-a*p,e[t+2]=c*m+u*p+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(r/2),h=a(s/2),f=l(i/2),p=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"YXZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"ZXY":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"ZYX":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"YZX":this._x=f*u*h+c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h-f*p*m;break;case"XZY":this._x=f*u*h-c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h+f*p*m;break;default:Xe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-i*c,this._z=s*u+o*c+i*l-r*a,this._w=o*u-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var O=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(km.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(km.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),u=2*(a*t-s*r),h=2*(s*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Yh.copy(this).projectOnVector(e),this.sub(Yh)}reflect(e){return this.sub(Yh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yh=new O,km=new Ii;var et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],m=i[8],M=r[0],d=r[3],g=r[6],v=r[1],T=r[4],y=r[7],C=r[2],A=r[5],x=r[8];return s[0]=o*M+a*v+l*C,s[3]=o*d+a*T+l*A,s[6]=o*g+a*y+l*x,s[1]=c*M+u*v+h*C,s[4]=c*d+u*T+h*A,s[7]=c*g+u*y+h*x,s[2]=f*M+p*v+m*C,s[5]=f*d+p*T+m*A,s[8]=f*g+p*y+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*s*u+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*s,p=c*s-o*l,m=t*h+i*f+r*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/m;return e[0]=h*M,e[1]=(r*c-u*i)*M,e[2]=(a*i-r*o)*M,e[3]=f*M,e[4]=(u*t-r*l)*M,e[5]=(r*s-a*t)*M,e[6]=p*M,e[7]=(i*l-c*t)*M,e[8]=(o*t-i*s)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ts("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($h.makeScale(e,t)),this}rotate(e){return Ts("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($h.makeRotation(-e)),this}translate(e,t){return Ts("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($h.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},$h=new et;var zm=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Gm=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Jy(){let n={enabled:!0,workingColorSpace:ws,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Pt&&(r.r=qn(r.r),r.g=qn(r.g),r.b=qn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(r.r=As(r.r),r.g=As(r.g),r.b=As(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Cn?Es:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ws]:{primaries:e,whitePoint:i,transfer:Es,toXYZ:zm,fromXYZ:Gm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:wi},outputColorSpaceConfig:{drawingBufferColorSpace:wi}},[wi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:zm,fromXYZ:Gm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:wi}}}),n}var _t=Jy();function qn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function As(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Eo,Vc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Eo===void 0&&(Eo=wo("canvas")),Eo.width=e.width,Eo.height=e.height;let r=Eo.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=Eo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=wo("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=qn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(qn(t[i]/255)*255):t[i]=qn(t[i]);return{data:t,width:e.width,height:e.height}}else return Xe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var Qy=0,Zr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Qy++}),this.uuid=Pn(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Kh(r[o].image)):s.push(Kh(r[o]))}else s=Kh(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Kh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Vc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Xe("Texture: Unable to serialize Texture."),{})}var jy=0,Zh=new O,ti=class n extends Vi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=tn,r=tn,s=xi,o=mn,a=Hi,l=ui,c=n.DEFAULT_ANISOTROPY,u=Cn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:jy++}),this.uuid=Pn(),this.name="",this.source=new Zr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new le(0,0),this.repeat=new le(1,1),this.center=new le(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zh).x}get height(){return this.source.getSize(Zh).y}get depth(){return this.source.getSize(Zh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Xe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Xe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Wh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Kr:e.x=e.x-Math.floor(e.x);break;case tn:e.x=e.x<0?0:1;break;case Pa:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Kr:e.y=e.y-Math.floor(e.y);break;case tn:e.y=e.y<0?0:1;break;case Pa:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=Wh;ti.DEFAULT_ANISOTROPY=1;var It=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],m=l[9],M=l[2],d=l[6],g=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-M)<.01&&Math.abs(m-d)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+M)<.1&&Math.abs(m+d)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,y=(p+1)/2,C=(g+1)/2,A=(u+f)/4,x=(h+M)/4,w=(m+d)/4;return T>y&&T>C?T<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(T),r=A/i,s=x/i):y>C?y<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(y),i=A/r,s=w/r):C<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(C),i=x/s,r=w/s),this.set(i,r,s,t),this}let v=Math.sqrt((d-m)*(d-m)+(h-M)*(h-M)+(f-u)*(f-u));return Math.abs(v)<.001&&(v=1),this.x=(d-m)/v,this.y=(h-M)/v,this.z=(f-u)/v,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var Wc=class extends Vi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ti({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Zr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var zi=class extends Wc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var To=class extends ti{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Jt,this.minFilter=Jt,this.wrapR=tn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Xc=class extends ti{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Jt,this.minFilter=Jt,this.wrapR=tn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var st=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d)}set(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=f,g[3]=p,g[7]=m,g[11]=M,g[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/Ao.setFromMatrixColumn(e,0).length(),s=1/Ao.setFromMatrixColumn(e,1).length(),o=1/Ao.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){let f=o*u,p=o*h,m=a*u,M=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+m*c,t[5]=f-M*c,t[9]=-a*l,t[2]=M-f*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,m=c*u,M=c*h;t[0]=f+M*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=M+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,m=c*u,M=c*h;t[0]=f-M*a,t[4]=-o*h,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=M-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,m=a*u,M=a*h;t[0]=l*u,t[4]=m*c-p,t[8]=f*c+M,t[1]=l*h,t[5]=M*c+f,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,m=a*l,M=a*c;t[0]=l*u,t[4]=M-f*h,t[8]=m*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+m,t[10]=f-M*h}else if(e.order==="XZY"){let f=o*l,p=o*c,m=a*l,M=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+M,t[5]=o*u,t[9]=p*h-m,t[2]=m*h-p,t[6]=a*u,t[10]=M*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(eS,e,tS)}lookAt(e,t,i){let r=this.elements;return _n.subVectors(e,t),_n.lengthSq()===0&&(_n.z=1),_n.normalize(),Jr.crossVectors(i,_n),Jr.lengthSq()===0&&(Math.abs(i.z)===1?_n.x+=1e-4:_n.z+=1e-4,_n.normalize(),Jr.crossVectors(i,_n)),Jr.normalize(),qc.crossVectors(_n,Jr),r[0]=Jr.x,r[4]=qc.x,r[8]=_n.x,r[1]=Jr.y,r[5]=qc.y,r[9]=_n.y,r[2]=Jr.z,r[6]=qc.z,r[10]=_n.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],m=i[2],M=i[6],d=i[10],g=i[14],v=i[3],T=i[7],y=i[11],C=i[15],A=r[0],x=r[4],w=r[8],B=r[12],D=r[1],L=r[5],z=r[9],W=r[13],I=r[2],H=r[6],q=r[10],G=r[14],ce=r[3],K=r[7],Q=r[11],ee=r[15];return s[0]=o*A+a*D+l*I+c*ce,s[4]=o*x+a*L+l*H+c*K,s[8]=o*w+a*z+l*q+c*Q,s[12]=o*B+a*W+l*G+c*ee,s[1]=u*A+h*D+f*I+p*ce,s[5]=u*x+h*L+f*H+p*K,s[9]=u*w+h*z+f*q+p*Q,s[13]=u*B+h*W+f*G+p*ee,s[2]=m*A+M*D+d*I+g*ce,s[6]=m*x+M*L+d*H+g*K,s[10]=m*w+M*z+d*q+g*Q,s[14]=m*B+M*W+d*G+g*ee,s[3]=v*A+T*D+y*I+C*ce,s[7]=v*x+T*L+y*H+C*K,s[11]=v*w+T*z+y*q+C*Q,s[15]=v*B+T*W+y*G+C*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],m=e[3],M=e[7],d=e[11],g=e[15],v=l*p-c*f,T=a*p-c*h,y=a*f-l*h,C=o*p-c*u,A=o*f-l*u,x=o*h-a*u;return t*(M*v-d*T+g*y)-i*(m*v-d*C+g*A)+r*(m*T-M*C+g*x)-s*(m*y-M*A+d*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],m=e[12],M=e[13],d=e[14],g=e[15],v=t*a-i*o,T=t*l-r*o,y=t*c-s*o,C=i*l-r*a,A=i*c-s*a,x=r*c-s*l,w=u*M-h*m,B=u*d-f*m,D=u*g-p*m,L=h*d-f*M,z=h*g-p*M,W=f*g-p*d,I=v*W-T*z+y*L+C*D-A*B+x*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/I;return e[0]=(a*W-l*z+c*L)*H,e[1]=(r*z-i*W-s*L)*H,e[2]=(M*x-d*A+g*C)*H,e[3]=(f*A-h*x-p*C)*H,e[4]=(l*D-o*W-c*B)*H,e[5]=(t*W-r*D+s*B)*H,e[6]=(d*y-m*x-g*T)*H,e[7]=(u*x-f*y+p*T)*H,e[8]=(o*z-a*D+c*w)*H,e[9]=(i*D-t*z-s*w)*H,e[10]=(m*A-M*y+g*v)*H,e[11]=(h*y-u*A-p*v)*H,e[12]=(a*B-o*L-l*w)*H,e[13]=(t*L-i*B+r*w)*H,e[14]=(M*T-m*C-d*v)*H,e[15]=(u*C-h*T+f*v)*H,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+i,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,h=a+a,f=s*c,p=s*u,m=s*h,M=o*u,d=o*h,g=a*h,v=l*c,T=l*u,y=l*h,C=i.x,A=i.y,x=i.z;return r[0]=(1-(M+g))*C,r[1]=(p+y)*C,r[2]=(m-T)*C,r[3]=0,r[4]=(p-y)*A,r[5]=(1-(f+g))*A,r[6]=(d+v)*A,r[7]=0,r[8]=(m+T)*x,r[9]=(d-v)*x,r[10]=(1-(f+M))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=Ao.set(r[0],r[1],r[2]).length(),a=Ao.set(r[4],r[5],r[6]).length(),l=Ao.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Yn.copy(this);let c=1/o,u=1/a,h=1/l;return Yn.elements[0]*=c,Yn.elements[1]*=c,Yn.elements[2]*=c,Yn.elements[4]*=u,Yn.elements[5]*=u,Yn.elements[6]*=u,Yn.elements[8]*=h,Yn.elements[9]*=h,Yn.elements[10]*=h,t.setFromRotationMatrix(Yn),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=ki,l=!1){let c=this.elements,u=2*s/(t-e),h=2*s/(i-r),f=(t+e)/(t-e),p=(i+r)/(i-r),m,M;if(l)m=s/(o-s),M=o*s/(o-s);else if(a===ki)m=-(o+s)/(o-s),M=-2*o*s/(o-s);else if(a===Tr)m=-o/(o-s),M=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=ki,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-r),f=-(t+e)/(t-e),p=-(i+r)/(i-r),m,M;if(l)m=1/(o-s),M=o/(o-s);else if(a===ki)m=-2/(o-s),M=-(o+s)/(o-s);else if(a===Tr)m=-1/(o-s),M=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ao=new O,Yn=new st,eS=new O(0,0,0),tS=new O(1,1,1),Jr=new O,qc=new O,_n=new O;var Hm=new st,Vm=new Ii,Ln=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(xt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Xe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Hm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Hm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Vm.setFromEuler(this),this.setFromQuaternion(Vm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ln.DEFAULT_ORDER="XYZ";var Ro=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var iS=0,Wm=new O,Co=new Ii,Ar=new st,Yc=new O,ul=new O,nS=new O,rS=new Ii,Xm=new O(1,0,0),qm=new O(0,1,0),Ym=new O(0,0,1),$m={type:"added"},sS={type:"removed"},Po={type:"childadded",child:null},Jh={type:"childremoved",child:null},Qt=class n extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:iS++}),this.uuid=Pn(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new O,t=new Ln,i=new Ii,r=new O(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new st},normalMatrix:{value:new et}}),this.matrix=new st,this.matrixWorld=new st,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ro,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.multiply(Co),this}rotateOnWorldAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.premultiply(Co),this}rotateX(e){return this.rotateOnAxis(Xm,e)}rotateY(e){return this.rotateOnAxis(qm,e)}rotateZ(e){return this.rotateOnAxis(Ym,e)}translateOnAxis(e,t){return Wm.copy(e).applyQuaternion(this.quaternion),this.position.add(Wm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Xm,e)}translateY(e){return this.translateOnAxis(qm,e)}translateZ(e){return this.translateOnAxis(Ym,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ar.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Yc.copy(e):Yc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),ul.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ar.lookAt(ul,Yc,this.up):Ar.lookAt(Yc,ul,this.up),this.quaternion.setFromRotationMatrix(Ar),r&&(Ar.extractRotation(r.matrixWorld),Co.setFromRotationMatrix(Ar),this.quaternion.premultiply(Co.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(bt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent($m),Po.child=e,this.dispatchEvent(Po),Po.child=null):bt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(sS),Jh.child=e,this.dispatchEvent(Jh),Jh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ar.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ar.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ar),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent($m),Po.child=e,this.dispatchEvent(Po),Po.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ul,e,nS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ul,rS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(e.shapes,h)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new O(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var rn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var oS={type:"move"},Lo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let d=t.getJointPose(M,i),g=this._getHandJoint(c,M);d!==null&&(g.matrix.fromArray(d.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=d.radius),g.visible=d!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(oS)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new rn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var Km={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qr={h:0,s:0,l:0},$c={h:0,s:0,l:0};function Qh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var tt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=wi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=_t.workingColorSpace){if(e=Um(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Qh(o,s,e+1/3),this.g=Qh(o,s,e),this.b=Qh(o,s,e-1/3)}return _t.colorSpaceToWorking(this,r),this}setStyle(e,t=wi){function i(s){s!==void 0&&parseFloat(s)<1&&Xe("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Xe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Xe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=wi){let i=Km[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Xe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=qn(e.r),this.g=qn(e.g),this.b=qn(e.b),this}copyLinearToSRGB(e){return this.r=As(e.r),this.g=As(e.g),this.b=As(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=wi){return _t.workingToColorSpace(Xi.copy(this),e),Math.round(xt(Xi.r*255,0,255))*65536+Math.round(xt(Xi.g*255,0,255))*256+Math.round(xt(Xi.b*255,0,255))}getHexString(e=wi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Xi.copy(this),t);let i=Xi.r,r=Xi.g,s=Xi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-i)/h+2;break;case s:l=(i-r)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Xi.copy(this),t),e.r=Xi.r,e.g=Xi.g,e.b=Xi.b,e}getStyle(e=wi){_t.workingToColorSpace(Xi.copy(this),e);let t=Xi.r,i=Xi.g,r=Xi.b;return e!==wi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Qr),this.setHSL(Qr.h+e,Qr.s+t,Qr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Qr),e.getHSL($c);let i=Gc(Qr.h,$c.h,t),r=Gc(Qr.s,$c.s,t),s=Gc(Qr.l,$c.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xi=new tt;tt.NAMES=Km;var hl=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ln,this.environmentIntensity=1,this.environmentRotation=new Ln,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var $n=new O,Rr=new O,jh=new O,Cr=new O,Do=new O,Io=new O,Zm=new O,ef=new O,tf=new O,nf=new O,rf=new It,sf=new It,of=new It,jr=class n{constructor(e=new O,t=new O,i=new O){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),$n.subVectors(e,t),r.cross($n);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){$n.subVectors(r,t),Rr.subVectors(i,t),jh.subVectors(e,t);let o=$n.dot($n),a=$n.dot(Rr),l=$n.dot(jh),c=Rr.dot(Rr),u=Rr.dot(jh),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-p-m,m,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Cr)===null?!1:Cr.x>=0&&Cr.y>=0&&Cr.x+Cr.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Cr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Cr.x),l.addScaledVector(o,Cr.y),l.addScaledVector(a,Cr.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return rf.setScalar(0),sf.setScalar(0),of.setScalar(0),rf.fromBufferAttribute(e,t),sf.fromBufferAttribute(e,i),of.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(rf,s.x),o.addScaledVector(sf,s.y),o.addScaledVector(of,s.z),o}static isFrontFacing(e,t,i,r){return $n.subVectors(i,t),Rr.subVectors(e,t),$n.cross(Rr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $n.subVectors(this.c,this.b),Rr.subVectors(this.a,this.b),$n.cross(Rr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;Do.subVectors(r,i),Io.subVectors(s,i),ef.subVectors(e,i);let l=Do.dot(ef),c=Io.dot(ef);if(l<=0&&c<=0)return t.copy(i);tf.subVectors(e,r);let u=Do.dot(tf),h=Io.dot(tf);if(u>=0&&h<=u)return t.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Do,o);nf.subVectors(e,s);let p=Do.dot(nf),m=Io.dot(nf);if(m>=0&&p<=m)return t.copy(s);let M=p*c-l*m;if(M<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Io,a);let d=u*m-p*h;if(d<=0&&h-u>=0&&p-m>=0)return Zm.subVectors(s,r),a=(h-u)/(h-u+(p-m)),t.copy(r).addScaledVector(Zm,a);let g=1/(d+M+f);return o=M*g,a=f*g,t.copy(i).addScaledVector(Do,o).addScaledVector(Io,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Dn=class{constructor(e=new O(1/0,1/0,1/0),t=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Kn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Kn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Kn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Kn):Kn.fromBufferAttribute(s,o),Kn.applyMatrix4(e.matrixWorld),this.expandByPoint(Kn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Kc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Kc.copy(i.boundingBox)),Kc.applyMatrix4(e.matrixWorld),this.union(Kc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Kn),Kn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(fl),Zc.subVectors(this.max,fl),Fo.subVectors(e.a,fl),Uo.subVectors(e.b,fl),No.subVectors(e.c,fl),es.subVectors(Uo,Fo),ts.subVectors(No,Uo),Rs.subVectors(Fo,No);let t=[0,-es.z,es.y,0,-ts.z,ts.y,0,-Rs.z,Rs.y,es.z,0,-es.x,ts.z,0,-ts.x,Rs.z,0,-Rs.x,-es.y,es.x,0,-ts.y,ts.x,0,-Rs.y,Rs.x,0];return!af(t,Fo,Uo,No,Zc)||(t=[1,0,0,0,1,0,0,0,1],!af(t,Fo,Uo,No,Zc))?!1:(Jc.crossVectors(es,ts),t=[Jc.x,Jc.y,Jc.z],af(t,Fo,Uo,No,Zc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Kn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Kn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Pr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Pr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Pr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Pr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Pr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Pr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Pr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Pr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Pr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Pr=[new O,new O,new O,new O,new O,new O,new O,new O],Kn=new O,Kc=new Dn,Fo=new O,Uo=new O,No=new O,es=new O,ts=new O,Rs=new O,fl=new O,Zc=new O,Jc=new O,Cs=new O;function af(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){Cs.fromArray(n,s);let a=r.x*Math.abs(Cs.x)+r.y*Math.abs(Cs.y)+r.z*Math.abs(Cs.z),l=e.dot(Cs),c=t.dot(Cs),u=i.dot(Cs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var _i=new O,Qc=new le,aS=0,vn=class extends Vi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:aS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Am,this.updateRanges=[],this.gpuType=bi,this.version=0,this._normalizationScale=e!==void 0?Hc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Qc.fromBufferAttribute(this,t),Qc.applyMatrix3(e),this.setXY(t,Qc.x,Qc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix3(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix4(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyNormalMatrix(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.transformDirection(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Om(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Bm(e,this.array)}};var Oo=class extends vn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Bo=class extends vn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mt=class extends vn{constructor(e,t,i){super(new Float32Array(e),t,i)}};var lS=new Dn,pl=new O,lf=new O,Zn=class{constructor(e=new O,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):lS.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;pl.subVectors(e,this.center);let t=pl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(pl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(lf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(pl.copy(e.center).add(lf)),this.expandByPoint(pl.copy(e.center).sub(lf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var cS=0,In=new st,cf=new Qt,ko=new O,Mn=new Dn,dl=new Dn,Fi=new O,Gt=class n extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:cS++}),this.uuid=Pn(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Pm(e)?Bo:Oo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new et().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return In.makeRotationFromQuaternion(e),this.applyMatrix4(In),this}rotateX(e){return In.makeRotationX(e),this.applyMatrix4(In),this}rotateY(e){return In.makeRotationY(e),this.applyMatrix4(In),this}rotateZ(e){return In.makeRotationZ(e),this.applyMatrix4(In),this}translate(e,t,i){return In.makeTranslation(e,t,i),this.applyMatrix4(In),this}scale(e,t,i){return In.makeScale(e,t,i),this.applyMatrix4(In),this}lookAt(e){return cf.lookAt(e),cf.updateMatrix(),this.applyMatrix4(cf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ko).negate(),this.translate(ko.x,ko.y,ko.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Xe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Dn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){bt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Mn.setFromBufferAttribute(s),this.morphTargetsRelative?(Fi.addVectors(this.boundingBox.min,Mn.min),this.boundingBox.expandByPoint(Fi),Fi.addVectors(this.boundingBox.max,Mn.max),this.boundingBox.expandByPoint(Fi)):(this.boundingBox.expandByPoint(Mn.min),this.boundingBox.expandByPoint(Mn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&bt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){bt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(e){let i=this.boundingSphere.center;if(Mn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];dl.setFromBufferAttribute(a),this.morphTargetsRelative?(Fi.addVectors(Mn.min,dl.min),Mn.expandByPoint(Fi),Fi.addVectors(Mn.max,dl.max),Mn.expandByPoint(Fi)):(Mn.expandByPoint(dl.min),Mn.expandByPoint(dl.max))}Mn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Fi.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Fi));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fi.fromBufferAttribute(a,c),l&&(ko.fromBufferAttribute(e,c),Fi.add(ko)),r=Math.max(r,i.distanceToSquared(Fi))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&bt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){bt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new vn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new O,l[B]=new O;let u=new O,h=new O,f=new O,p=new le,m=new le,M=new le,d=new O,g=new O;function v(B,D,L){c[B]=c[D]=c[L]=1,u.fromBufferAttribute(i,B),h.fromBufferAttribute(i,D),f.fromBufferAttribute(i,L),p.fromBufferAttribute(s,B),m.fromBufferAttribute(s,D),M.fromBufferAttribute(s,L),h.sub(u),f.sub(u),m.sub(p),M.sub(p);let z=1/(m.x*M.y-M.x*m.y);isFinite(z)&&(d.copy(h).multiplyScalar(M.y).addScaledVector(f,-m.y).multiplyScalar(z),g.copy(f).multiplyScalar(m.x).addScaledVector(h,-M.x).multiplyScalar(z),a[B].add(d),a[D].add(d),a[L].add(d),l[B].add(g),l[D].add(g),l[L].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let B=0,D=T.length;B<D;++B){let L=T[B],z=L.start,W=L.count;for(let I=z,H=z+W;I<H;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let y=new O,C=new O,A=new O,x=new O;function w(B){A.fromBufferAttribute(r,B),x.copy(A);let D=a[B];y.copy(D),y.sub(A.multiplyScalar(A.dot(D))).normalize(),C.crossVectors(x,D);let z=C.dot(l[B])<0?-1:1;o.setXYZW(B,y.x,y.y,y.z,z)}for(let B=0,D=i.count;B<D;++B)c[B]&&w(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new vn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let r=new O,s=new O,o=new O,a=new O,l=new O,c=new O,u=new O,h=new O;if(e)for(let f=0,p=e.count;f<p;f+=3){let m=e.getX(f+0),M=e.getX(f+1),d=e.getX(f+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,M),o.fromBufferAttribute(t,d),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,M),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(M,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Fi.fromBufferAttribute(e,t),Fi.normalize(),e.setXYZ(t,Fi.x,Fi.y,Fi.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,m=0;for(let M=0,d=l.length;M<d;M++){a.isInterleavedBufferAttribute?p=l[M]*a.data.stride+a.offset:p=l[M]*u;for(let g=0;g<u;g++)f[m++]=c[p++]}return new vn(f,u,h)}if(this.index===null)return Xe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var uf=new O,uS=new O,hS=new et,yn=class{constructor(e=new O(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=uf.subVectors(i,t).cross(uS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(uf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||hS.getNormalMatrix(e),r=this.coplanarPoint(uf).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var fS=0,Fn=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fS++}),this.uuid=Pn(),this.name="",this.type="Material",this.blending=Xr,this.side=Rn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=vc,this.blendDst=Mc,this.blendEquation=qr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new tt(0,0,0),this.blendAlpha=0,this.depthFunc=Yr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ym,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Nc,this.stencilZFail=Nc,this.stencilZPass=Nc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Xe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Xe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new tt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new yn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new le().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new le().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Lr=new O,hf=new O,jc=new O,eu=new O,tu=class{constructor(e=new O,t=new O(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Lr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Lr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Lr.copy(this.origin).addScaledVector(this.direction,t),Lr.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){hf.copy(e).add(t).multiplyScalar(.5),jc.copy(t).sub(e).normalize(),eu.copy(this.origin).sub(hf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(jc),a=eu.dot(this.direction),l=-eu.dot(jc),c=eu.lengthSq(),u=Math.abs(1-o*o),h,f,p,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let M=1/u;h*=M,f*=M,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),p=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),p=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),p=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(hf).addScaledVector(jc,f),p}intersectSphere(e,t){if(e.radius<0)return null;Lr.subVectors(e.center,this.origin);let i=Lr.dot(this.direction),r=Lr.dot(Lr)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),u>=0?(s=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(s=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Lr)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,p=e.z-o.z,m=t.x-o.x,M=t.y-o.y,d=t.z-o.z,g=i.x-o.x,v=i.y-o.y,T=i.z-o.z,y=Math.abs(l),C=Math.abs(c),A=Math.abs(u),x,w,B,D,L,z,W,I,H,q,G,ce;if(y>=C&&y>=A?(B=l,z=h,H=m,ce=g,l>=0?(x=c,w=u,D=f,L=p,W=M,I=d,q=v,G=T):(x=u,w=c,D=p,L=f,W=d,I=M,q=T,G=v)):C>=A?(B=c,z=f,H=M,ce=v,c>=0?(x=u,w=l,D=p,L=h,W=d,I=m,q=T,G=g):(x=l,w=u,D=h,L=p,W=m,I=d,q=g,G=T)):(B=u,z=p,H=d,ce=T,u>=0?(x=l,w=c,D=h,L=f,W=m,I=M,q=g,G=v):(x=c,w=l,D=f,L=h,W=M,I=m,q=v,G=g)),B===0)return null;let K=x/B,Q=w/B,ee=1/B,de=D-K*z,ue=L-Q*z,j=W-K*H,xe=I-Q*H,ve=q-K*ce,De=G-Q*ce,we=ve*xe-De*j,He=de*De-ue*ve,ot=j*ue-xe*de;if(r){if(we<0||He<0||ot<0)return null}else if((we<0||He<0||ot<0)&&(we>0||He>0||ot>0))return null;let Je=we+He+ot;if(Je===0)return null;let at=ee*(we*z+He*H+ot*ce);return(Je>0?at<0:at>0)?null:this.at(at/Je,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var Un=class extends Fn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ln,this.combine=co,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var Jm=new st,Ps=new tu,iu=new Zn,Qm=new O,nu=new O,ru=new O,su=new O,ff=new O,ou=new O,jm=new O,au=new O,At=class extends Qt{constructor(e=new Gt,t=new Un){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){ou.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(ff.fromBufferAttribute(h,e),o?ou.addScaledVector(ff,u):ou.addScaledVector(ff.sub(t),u))}t.add(ou)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),iu.copy(i.boundingSphere),iu.applyMatrix4(s),Ps.copy(e.ray).recast(e.near),!(iu.containsPoint(Ps.origin)===!1&&(Ps.intersectSphere(iu,Qm)===null||Ps.origin.distanceToSquared(Qm)>(e.far-e.near)**2))&&(Jm.copy(s).invert(),Ps.copy(e.ray).applyMatrix4(Jm),!(i.boundingBox!==null&&Ps.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ps)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,M=f.length;m<M;m++){let d=f[m],g=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let y=v,C=T;y<C;y+=3){let A=a.getX(y),x=a.getX(y+1),w=a.getX(y+2);r=lu(this,g,e,i,c,u,h,A,x,w),r&&(r.faceIndex=Math.floor(y/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),M=Math.min(a.count,p.start+p.count);for(let d=m,g=M;d<g;d+=3){let v=a.getX(d),T=a.getX(d+1),y=a.getX(d+2);r=lu(this,o,e,i,c,u,h,v,T,y),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,M=f.length;m<M;m++){let d=f[m],g=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let y=v,C=T;y<C;y+=3){let A=y,x=y+1,w=y+2;r=lu(this,g,e,i,c,u,h,A,x,w),r&&(r.faceIndex=Math.floor(y/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),M=Math.min(l.count,p.start+p.count);for(let d=m,g=M;d<g;d+=3){let v=d,T=d+1,y=d+2;r=lu(this,o,e,i,c,u,h,v,T,y),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}};function pS(n,e,t,i,r,s,o,a){let l;if(e.side===ei?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===Rn,a),l===null)return null;au.copy(a),au.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(au);return c<t.near||c>t.far?null:{distance:c,point:au.clone(),object:n}}function lu(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,nu),n.getVertexPosition(l,ru),n.getVertexPosition(c,su);let u=pS(n,e,t,i,nu,ru,su,jm);if(u){let h=new O;jr.getBarycoord(jm,nu,ru,su,h),r&&(u.uv=jr.getInterpolatedAttribute(r,a,l,c,h,new le)),s&&(u.uv1=jr.getInterpolatedAttribute(s,a,l,c,h,new le)),o&&(u.normal=jr.getInterpolatedAttribute(o,a,l,c,h,new O),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new O,materialIndex:0};jr.getNormal(nu,ru,su,f.normal),u.face=f,u.barycoord=h}return u}var zo=class extends ti{constructor(e=null,t=1,i=1,r,s,o,a,l,c=Jt,u=Jt,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fr=class extends vn{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Go=new st,eg=new st,cu=[],tg=new Dn,dS=new st,ml=new At,gl=new Zn,Jn=class extends At{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new fr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,dS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Dn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Go),tg.copy(e.boundingBox).applyMatrix4(Go),this.boundingBox.union(tg)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Zn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Go),gl.copy(e.boundingSphere).applyMatrix4(Go),this.boundingSphere.union(gl)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(ml.geometry=this.geometry,ml.material=this.material,ml.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),gl.copy(this.boundingSphere),gl.applyMatrix4(i),e.ray.intersectsSphere(gl)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,Go),eg.multiplyMatrices(i,Go),ml.matrixWorld=eg,ml.raycast(e,cu);for(let o=0,a=cu.length;o<a;o++){let l=cu[o];l.instanceId=s,l.object=this,t.push(l)}cu.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new fr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new zo(new Float32Array(r*this.count),r,this.count,mo,bi));let s=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=r*e;return s[l]=a,s.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var Ls=new Zn,mS=new le(.5,.5),uu=new O,Qn=class{constructor(e=new yn,t=new yn,i=new yn,r=new yn,s=new yn,o=new yn){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ki,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],p=s[7],m=s[8],M=s[9],d=s[10],g=s[11],v=s[12],T=s[13],y=s[14],C=s[15];if(r[0].setComponents(c-o,p-u,g-m,C-v).normalize(),r[1].setComponents(c+o,p+u,g+m,C+v).normalize(),r[2].setComponents(c+a,p+h,g+M,C+T).normalize(),r[3].setComponents(c-a,p-h,g-M,C-T).normalize(),i)r[4].setComponents(l,f,d,y).normalize(),r[5].setComponents(c-l,p-f,g-d,C-y).normalize();else if(r[4].setComponents(c-l,p-f,g-d,C-y).normalize(),t===ki)r[5].setComponents(c+l,p+f,g+d,C+y).normalize();else if(t===Tr)r[5].setComponents(l,f,d,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ls.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ls.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ls)}intersectsSprite(e){Ls.center.set(0,0,0);let t=mS.distanceTo(e.center);return Ls.radius=.7071067811865476+t,Ls.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ls)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(uu.x=r.normal.x>0?e.max.x:e.min.x,uu.y=r.normal.y>0?e.max.y:e.min.y,uu.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(uu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var ig=new st,hu=class n{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];ig.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new Qn),i[r].setFromProjectionMatrix(ig,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Qn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Ho=class extends ti{constructor(e=[],t=hr,i,r,s,o,a,l,c,u){super(e,t,i,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var is=class extends ti{constructor(e,t,i,r,s,o,a,l,c){super(e,t,i,r,s,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Sn=class extends ti{constructor(e,t,i=Li,r,s,o,a=Jt,l=Jt,c,u=nn,h=1){if(u!==nn&&u!==gn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,r,s,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Zr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var Vo=class extends Sn{constructor(e,t=Li,i=hr,r,s,o=Jt,a=Jt,l,c=nn){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var Wo=class extends ti{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var ns=class n extends Gt{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function m(M,d,g,v,T,y,C,A,x,w,B){let D=y/x,L=C/w,z=y/2,W=C/2,I=A/2,H=x+1,q=w+1,G=0,ce=0,K=new O;for(let Q=0;Q<q;Q++){let ee=Q*L-W;for(let de=0;de<H;de++){let ue=de*D-z;K[M]=ue*v,K[d]=ee*T,K[g]=I,c.push(K.x,K.y,K.z),K[M]=0,K[d]=0,K[g]=A>0?1:-1,u.push(K.x,K.y,K.z),h.push(de/x),h.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let ee=0;ee<x;ee++){let de=f+ee+H*Q,ue=f+ee+H*(Q+1),j=f+(ee+1)+H*(Q+1),xe=f+(ee+1)+H*Q;l.push(de,ue,xe),l.push(ue,j,xe),ce+=6}a.addGroup(p,ce,B),p+=ce,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var xl=class n extends Gt{constructor(e=1,t=32,i=0,r=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:i,thetaLength:r},t=Math.max(3,t);let s=[],o=[],a=[],l=[],c=new O,u=new le;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let p=i+h/t*r;c.x=e*Math.cos(p),c.y=e*Math.sin(p),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)s.push(h,h+1,0);this.setIndex(s),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.segments,e.thetaStart,e.thetaLength)}};var _l=class n extends Gt{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],f=[],p=[],m=0,M=[],d=i/2,g=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(p,2));function v(){let y=new O,C=new O,A=0,x=(t-e)/i;for(let w=0;w<=s;w++){let B=[],D=w/s,L=D*(t-e)+e;for(let z=0;z<=r;z++){let W=z/r,I=W*l+a,H=Math.sin(I),q=Math.cos(I);C.x=L*H,C.y=-D*i+d,C.z=L*q,h.push(C.x,C.y,C.z),y.set(H,x,q).normalize(),f.push(y.x,y.y,y.z),p.push(W,1-D),B.push(m++)}M.push(B)}for(let w=0;w<r;w++)for(let B=0;B<s;B++){let D=M[B][w],L=M[B+1][w],z=M[B+1][w+1],W=M[B][w+1];(e>0||B!==0)&&(u.push(D,L,W),A+=3),(t>0||B!==s-1)&&(u.push(L,z,W),A+=3)}c.addGroup(g,A,0),g+=A}function T(y){let C=m,A=new le,x=new O,w=0,B=y===!0?e:t,D=y===!0?1:-1;for(let z=1;z<=r;z++)h.push(0,d*D,0),f.push(0,D,0),p.push(.5,.5),m++;let L=m;for(let z=0;z<=r;z++){let I=z/r*l+a,H=Math.cos(I),q=Math.sin(I);x.x=B*q,x.y=d*D,x.z=B*H,h.push(x.x,x.y,x.z),f.push(0,D,0),A.x=H*.5+.5,A.y=q*.5*D+.5,p.push(A.x,A.y),m++}for(let z=0;z<r;z++){let W=C+z,I=L+z;y===!0?u.push(I,I+1,W):u.push(I+1,I,W),w+=3}c.addGroup(g,w,y===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ko={};Av(Ko,{ArcCurve:()=>fu,CatmullRomCurve3:()=>pu,CubicBezierCurve:()=>Xo,CubicBezierCurve3:()=>du,EllipseCurve:()=>rs,LineCurve:()=>qo,LineCurve3:()=>mu,QuadraticBezierCurve:()=>Yo,QuadraticBezierCurve3:()=>gu,SplineCurve:()=>$o});var ai=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Xe("Curve: .getPoint() not implemented.")}getPointAt(e,t){let i=this.getUtoTmapping(e);return this.getPoint(i,t)}getPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return t}getSpacedPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPointAt(i/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],i,r=this.getPoint(0),s=0;t.push(0);for(let o=1;o<=e;o++)i=this.getPoint(o/e),s+=i.distanceTo(r),t.push(s),r=i;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let i=this.getLengths(),r=0,s=i.length,o;t?o=t:o=e*i[s-1];let a=0,l=s-1,c;for(;a<=l;)if(r=Math.floor(a+(l-a)/2),c=i[r]-o,c<0)a=r+1;else if(c>0)l=r-1;else{l=r;break}if(r=l,i[r]===o)return r/(s-1);let u=i[r],f=i[r+1]-u,p=(o-u)/f;return(r+p)/(s-1)}getTangent(e,t){let r=e-1e-4,s=e+1e-4;r<0&&(r=0),s>1&&(s=1);let o=this.getPoint(r),a=this.getPoint(s),l=t||(o.isVector2?new le:new O);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let i=this.getUtoTmapping(e);return this.getTangent(i,t)}computeFrenetFrames(e,t=!1){let i=new O,r=[],s=[],o=[],a=new O,l=new st;for(let p=0;p<=e;p++){let m=p/e;r[p]=this.getTangentAt(m,new O)}s[0]=new O,o[0]=new O;let c=Number.MAX_VALUE,u=Math.abs(r[0].x),h=Math.abs(r[0].y),f=Math.abs(r[0].z);u<=c&&(c=u,i.set(1,0,0)),h<=c&&(c=h,i.set(0,1,0)),f<=c&&i.set(0,0,1),a.crossVectors(r[0],i).normalize(),s[0].crossVectors(r[0],a),o[0].crossVectors(r[0],s[0]);for(let p=1;p<=e;p++){if(s[p]=s[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(r[p-1],r[p]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(xt(r[p-1].dot(r[p]),-1,1));s[p].applyMatrix4(l.makeRotationAxis(a,m))}o[p].crossVectors(r[p],s[p])}if(t===!0){let p=Math.acos(xt(s[0].dot(s[e]),-1,1));p/=e,r[0].dot(a.crossVectors(s[0],s[e]))>0&&(p=-p);for(let m=1;m<=e;m++)s[m].applyMatrix4(l.makeRotationAxis(r[m],p*m)),o[m].crossVectors(r[m],s[m])}return{tangents:r,normals:s,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}};var rs=class extends ai{constructor(e=0,t=0,i=1,r=1,s=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=i,this.yRadius=r,this.aStartAngle=s,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new le){let i=t,r=Math.PI*2,s=this.aEndAngle-this.aStartAngle,o=Math.abs(s)<Number.EPSILON;for(;s<0;)s+=r;for(;s>r;)s-=r;s<Number.EPSILON&&(o?s=0:s=r),this.aClockwise===!0&&!o&&(s===r?s=-r:s=s-r);let a=this.aStartAngle+e*s,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return i.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}};var fu=class extends rs{constructor(e,t,i,r,s,o){super(e,t,i,i,r,s,o),this.isArcCurve=!0,this.type="ArcCurve"}};function gf(){let n=0,e=0,t=0,i=0;function r(s,o,a,l){n=s,e=a,t=-3*s+3*o-2*a-l,i=2*s-2*o+a+l}return{initCatmullRom:function(s,o,a,l,c){r(o,a,c*(a-s),c*(l-o))},initNonuniformCatmullRom:function(s,o,a,l,c,u,h){let f=(o-s)/c-(a-s)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,r(o,a,f,p)},calc:function(s){let o=s*s,a=o*s;return n+e*s+t*o+i*a}}}var ng=new O,rg=new O,pf=new gf,df=new gf,mf=new gf,pu=class extends ai{constructor(e=[],t=!1,i="centripetal",r=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=i,this.tension=r}getPoint(e,t=new O){let i=t,r=this.points,s=r.length,o=(s-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/s)+1)*s:l===0&&a===s-1&&(a=s-2,l=1);let c,u;this.closed||a>0?c=r[(a-1)%s]:(rg.subVectors(r[0],r[1]).add(r[0]),c=rg);let h=r[a%s],f=r[(a+1)%s];if(this.closed||a+2<s?u=r[(a+2)%s]:(ng.subVectors(r[s-1],r[s-2]).add(r[s-1]),u=ng),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),p),M=Math.pow(h.distanceToSquared(f),p),d=Math.pow(f.distanceToSquared(u),p);M<1e-4&&(M=1),m<1e-4&&(m=M),d<1e-4&&(d=M),pf.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,m,M,d),df.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,m,M,d),mf.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,m,M,d)}else this.curveType==="catmullrom"&&(pf.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),df.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),mf.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return i.set(pf.calc(l),df.calc(l),mf.calc(l)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(r.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let r=this.points[t];e.points.push(r.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(new O().fromArray(r))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function xf(n,e,t,i,r){let s=(i-e)*.5,o=(r-t)*.5,a=n*n,l=n*a;return(2*t-2*i+s+o)*l+(-3*t+3*i-2*s-o)*a+s*n+t}function gS(n,e){let t=1-n;return t*t*e}function xS(n,e){return 2*(1-n)*n*e}function _S(n,e){return n*n*e}function Ds(n,e,t,i){return gS(n,e)+xS(n,t)+_S(n,i)}function vS(n,e){let t=1-n;return t*t*t*e}function MS(n,e){let t=1-n;return 3*t*t*n*e}function yS(n,e){return 3*(1-n)*n*n*e}function SS(n,e){return n*n*n*e}function Is(n,e,t,i,r){return vS(n,e)+MS(n,t)+yS(n,i)+SS(n,r)}var Xo=class extends ai{constructor(e=new le,t=new le,i=new le,r=new le){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=i,this.v3=r}getPoint(e,t=new le){let i=t,r=this.v0,s=this.v1,o=this.v2,a=this.v3;return i.set(Is(e,r.x,s.x,o.x,a.x),Is(e,r.y,s.y,o.y,a.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}};var du=class extends ai{constructor(e=new O,t=new O,i=new O,r=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=i,this.v3=r}getPoint(e,t=new O){let i=t,r=this.v0,s=this.v1,o=this.v2,a=this.v3;return i.set(Is(e,r.x,s.x,o.x,a.x),Is(e,r.y,s.y,o.y,a.y),Is(e,r.z,s.z,o.z,a.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}};var qo=class extends ai{constructor(e=new le,t=new le){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new le){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new le){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var mu=class extends ai{constructor(e=new O,t=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new O){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new O){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var Yo=class extends ai{constructor(e=new le,t=new le,i=new le){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new le){let i=t,r=this.v0,s=this.v1,o=this.v2;return i.set(Ds(e,r.x,s.x,o.x),Ds(e,r.y,s.y,o.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var gu=class extends ai{constructor(e=new O,t=new O,i=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new O){let i=t,r=this.v0,s=this.v1,o=this.v2;return i.set(Ds(e,r.x,s.x,o.x),Ds(e,r.y,s.y,o.y),Ds(e,r.z,s.z,o.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var $o=class extends ai{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new le){let i=t,r=this.points,s=(r.length-1)*e,o=Math.floor(s),a=s-o,l=r[o===0?o:o-1],c=r[o],u=r[o>r.length-2?r.length-1:o+1],h=r[o>r.length-3?r.length-1:o+2];return i.set(xf(a,l.x,c.x,u.x,h.x),xf(a,l.y,c.y,u.y,h.y)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(r.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let r=this.points[t];e.points.push(r.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(new le().fromArray(r))}return this}};var xu=class extends ai{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let i=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Ko[i](t,e))}return this}getPoint(e,t){let i=e*this.getLength(),r=this.getCurveLengths(),s=0;for(;s<r.length;){if(r[s]>=i){let o=r[s]-i,a=this.curves[s],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}s++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let i=0,r=this.curves.length;i<r;i++)t+=this.curves[i].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],i;for(let r=0,s=this.curves;r<s.length;r++){let o=s[r],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let u=l[c];i&&i.equals(u)||(t.push(u),i=u)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let r=e.curves[t];this.curves.push(r.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,i=this.curves.length;t<i;t++){let r=this.curves[t];e.curves.push(r.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let r=e.curves[t];this.curves.push(new Ko[r.type]().fromJSON(r))}return this.cacheLengths=null,this}};var Dr=class extends xu{constructor(e){super(),this.type="Path",this.currentPoint=new le,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,i=e.length;t<i;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let i=new qo(this.currentPoint.clone(),new le(e,t));return this.curves.push(i),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,i,r){let s=new Yo(this.currentPoint.clone(),new le(e,t),new le(i,r));return this.curves.push(s),this.currentPoint.set(i,r),this}bezierCurveTo(e,t,i,r,s,o){let a=new Xo(this.currentPoint.clone(),new le(e,t),new le(i,r),new le(s,o));return this.curves.push(a),this.currentPoint.set(s,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),i=new $o(t);return this.curves.push(i),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,i,r,s,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,i,r,s,o),this}absarc(e,t,i,r,s,o){return this.absellipse(e,t,i,i,r,s,o),this}ellipse(e,t,i,r,s,o,a,l){let c=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(e+c,t+u,i,r,s,o,a,l),this}absellipse(e,t,i,r,s,o,a,l){let c=new rs(e,t,i,r,s,o,a,l);if(this.curves.length>0){let h=c.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(c);let u=c.getPoint(1);return this.currentPoint.copy(u),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}};var pr=class extends Dr{constructor(e){super(e),this.uuid=Pn(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let i=0,r=this.holes.length;i<r;i++)t[i]=this.holes[i].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let r=e.holes[t];this.holes.push(r.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,i=this.holes.length;t<i;t++){let r=this.holes[t];e.holes.push(r.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let r=e.holes[t];this.holes.push(new Dr().fromJSON(r))}return this}};function Mf(n,e,t=2){let i=e&&e.length,r=i?e[0]*t:n.length,s=og(n,0,r,t,!0),o=[];if(!s||s.next===s.prev)return o;let a,l,c;if(i&&(s=AS(n,e,s,t)),n.length>80*t){a=n[0],l=n[1];let u=a,h=l;for(let f=t;f<r;f+=t){let p=n[f],m=n[f+1];p<a&&(a=p),m<l&&(l=m),p>u&&(u=p),m>h&&(h=m)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return Ml(s,o,t,a,l,c,0),o}function og(n,e,t,i,r){let s;if(r===BS(n,e,t,i)>0)for(let o=e;o<t;o+=i)s=sg(o/i|0,n[o],n[o+1],s);else for(let o=t-i;o>=e;o-=i)s=sg(o/i|0,n[o],n[o+1],s);return s&&Zo(s,s.next)&&(Sl(s),s=s.next),s}function Fs(n,e){if(!n)return n;e||(e=n);let t=n,i;do if(i=!1,!t.steiner&&(Zo(t,t.next)||ii(t.prev,t,t.next)===0)){if(Sl(t),t=e=t.prev,t===t.next)break;i=!0}else t=t.next;while(i||t!==e);return e}function Ml(n,e,t,i,r,s,o){if(!n)return;!o&&s&&DS(n,i,r,s);let a=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(s?wS(n,i,r,s):bS(n)){e.push(l.i,n.i,c.i),Sl(n),n=c.next,a=c.next;continue}if(n=c,n===a){o?o===1?(n=ES(Fs(n),e),Ml(n,e,t,i,r,s,2)):o===2&&TS(n,e,t,i,r,s):Ml(Fs(n),e,t,i,r,s,1);break}}}function bS(n){let e=n.prev,t=n,i=n.next;if(ii(e,t,i)>=0)return!1;let r=e.x,s=t.x,o=i.x,a=e.y,l=t.y,c=i.y,u=Math.min(r,s,o),h=Math.min(a,l,c),f=Math.max(r,s,o),p=Math.max(a,l,c),m=i.next;for(;m!==e;){if(m.x>=u&&m.x<=f&&m.y>=h&&m.y<=p&&vl(r,a,s,l,o,c,m.x,m.y)&&ii(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function wS(n,e,t,i){let r=n.prev,s=n,o=n.next;if(ii(r,s,o)>=0)return!1;let a=r.x,l=s.x,c=o.x,u=r.y,h=s.y,f=o.y,p=Math.min(a,l,c),m=Math.min(u,h,f),M=Math.max(a,l,c),d=Math.max(u,h,f),g=_f(p,m,e,t,i),v=_f(M,d,e,t,i),T=n.prevZ,y=n.nextZ;for(;T&&T.z>=g&&y&&y.z<=v;){if(T.x>=p&&T.x<=M&&T.y>=m&&T.y<=d&&T!==r&&T!==o&&vl(a,u,l,h,c,f,T.x,T.y)&&ii(T.prev,T,T.next)>=0||(T=T.prevZ,y.x>=p&&y.x<=M&&y.y>=m&&y.y<=d&&y!==r&&y!==o&&vl(a,u,l,h,c,f,y.x,y.y)&&ii(y.prev,y,y.next)>=0))return!1;y=y.nextZ}for(;T&&T.z>=g;){if(T.x>=p&&T.x<=M&&T.y>=m&&T.y<=d&&T!==r&&T!==o&&vl(a,u,l,h,c,f,T.x,T.y)&&ii(T.prev,T,T.next)>=0)return!1;T=T.prevZ}for(;y&&y.z<=v;){if(y.x>=p&&y.x<=M&&y.y>=m&&y.y<=d&&y!==r&&y!==o&&vl(a,u,l,h,c,f,y.x,y.y)&&ii(y.prev,y,y.next)>=0)return!1;y=y.nextZ}return!0}function ES(n,e){let t=n;do{let i=t.prev,r=t.next.next;!Zo(i,r)&&lg(i,t,t.next,r)&&yl(i,r)&&yl(r,i)&&(e.push(i.i,t.i,r.i),Sl(t),Sl(t.next),t=n=r),t=t.next}while(t!==n);return Fs(t)}function TS(n,e,t,i,r,s){let o=n;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&US(o,a)){let l=cg(o,a);o=Fs(o,o.next),l=Fs(l,l.next),Ml(o,e,t,i,r,s,0),Ml(l,e,t,i,r,s,0);return}a=a.next}o=o.next}while(o!==n)}function AS(n,e,t,i){let r=[];for(let s=0,o=e.length;s<o;s++){let a=e[s]*i,l=s<o-1?e[s+1]*i:n.length,c=og(n,a,l,i,!1);c===c.next&&(c.steiner=!0),r.push(FS(c))}r.sort(RS);for(let s=0;s<r.length;s++)t=CS(r[s],t);return t}function RS(n,e){let t=n.x-e.x;if(t===0&&(t=n.y-e.y,t===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),r=(e.next.y-e.y)/(e.next.x-e.x);t=i-r}return t}function CS(n,e){let t=PS(n,e);if(!t)return e;let i=cg(t,n);return Fs(i,i.next),Fs(t,t.next)}function PS(n,e){let t=e,i=n.x,r=n.y,s=-1/0,o;if(Zo(n,t))return t;do{if(Zo(n,t.next))return t.next;if(r<=t.y&&r>=t.next.y&&t.next.y!==t.y){let h=t.x+(r-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(h<=i&&h>s&&(s=h,o=t.x<t.next.x?t:t.next,h===i))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,u=1/0;t=o;do{if(i>=t.x&&t.x>=l&&i!==t.x&&ag(r<c?i:s,r,l,c,r<c?s:i,r,t.x,t.y)){let h=Math.abs(r-t.y)/(i-t.x);yl(t,n)&&(h<u||h===u&&(t.x>o.x||t.x===o.x&&LS(o,t)))&&(o=t,u=h)}t=t.next}while(t!==a);return o}function LS(n,e){return ii(n.prev,n,e.prev)<0&&ii(e.next,n,n.next)<0}function DS(n,e,t,i){let r=n;do r.z===0&&(r.z=_f(r.x,r.y,e,t,i)),r.prevZ=r.prev,r.nextZ=r.next,r=r.next;while(r!==n);r.prevZ.nextZ=null,r.prevZ=null,IS(r)}function IS(n){let e,t=1;do{let i=n,r;n=null;let s=null;for(e=0;i;){e++;let o=i,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||i.z<=o.z)?(r=i,i=i.nextZ,a--):(r=o,o=o.nextZ,l--),s?s.nextZ=r:n=r,r.prevZ=s,s=r;i=o}s.nextZ=null,t*=2}while(e>1);return n}function _f(n,e,t,i,r){return n=(n-t)*r|0,e=(e-i)*r|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,n|e<<1}function FS(n){let e=n,t=n;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==n);return t}function ag(n,e,t,i,r,s,o,a){return(r-o)*(e-a)>=(n-o)*(s-a)&&(n-o)*(i-a)>=(t-o)*(e-a)&&(t-o)*(s-a)>=(r-o)*(i-a)}function vl(n,e,t,i,r,s,o,a){return!(n===o&&e===a)&&ag(n,e,t,i,r,s,o,a)}function US(n,e){return n.next.i!==e.i&&n.prev.i!==e.i&&!NS(n,e)&&(yl(n,e)&&yl(e,n)&&OS(n,e)&&(ii(n.prev,n,e.prev)||ii(n,e.prev,e))||Zo(n,e)&&ii(n.prev,n,n.next)>0&&ii(e.prev,e,e.next)>0)}function ii(n,e,t){return(e.y-n.y)*(t.x-e.x)-(e.x-n.x)*(t.y-e.y)}function Zo(n,e){return n.x===e.x&&n.y===e.y}function lg(n,e,t,i){let r=vu(ii(n,e,t)),s=vu(ii(n,e,i)),o=vu(ii(t,i,n)),a=vu(ii(t,i,e));return!!(r!==s&&o!==a||r===0&&_u(n,t,e)||s===0&&_u(n,i,e)||o===0&&_u(t,n,i)||a===0&&_u(t,e,i))}function _u(n,e,t){return e.x<=Math.max(n.x,t.x)&&e.x>=Math.min(n.x,t.x)&&e.y<=Math.max(n.y,t.y)&&e.y>=Math.min(n.y,t.y)}function vu(n){return n>0?1:n<0?-1:0}function NS(n,e){let t=n;do{if(t.i!==n.i&&t.next.i!==n.i&&t.i!==e.i&&t.next.i!==e.i&&lg(t,t.next,n,e))return!0;t=t.next}while(t!==n);return!1}function yl(n,e){return ii(n.prev,n,n.next)<0?ii(n,e,n.next)>=0&&ii(n,n.prev,e)>=0:ii(n,e,n.prev)<0||ii(n,n.next,e)<0}function OS(n,e){let t=n,i=!1,r=(n.x+e.x)/2,s=(n.y+e.y)/2;do t.y>s!=t.next.y>s&&t.next.y!==t.y&&r<(t.next.x-t.x)*(s-t.y)/(t.next.y-t.y)+t.x&&(i=!i),t=t.next;while(t!==n);return i}function cg(n,e){let t=vf(n.i,n.x,n.y),i=vf(e.i,e.x,e.y),r=n.next,s=e.prev;return n.next=e,e.prev=n,t.next=r,r.prev=t,i.next=t,t.prev=i,s.next=i,i.prev=s,i}function sg(n,e,t,i){let r=vf(n,e,t);return i?(r.next=i.next,r.prev=i,i.next.prev=r,i.next=r):(r.prev=r,r.next=r),r}function Sl(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function vf(n,e,t){return{i:n,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function BS(n,e,t,i){let r=0;for(let s=e,o=t-i;s<t;s+=i)r+=(n[o]-n[s])*(n[s+1]+n[o+1]),o=s;return r}var Mu=class{static triangulate(e,t,i=2){return Mf(e,t,i)}};var jn=class n{static area(e){let t=e.length,i=0;for(let r=t-1,s=0;s<t;r=s++)i+=e[r].x*e[s].y-e[s].x*e[r].y;return i*.5}static isClockWise(e){return n.area(e)<0}static triangulateShape(e,t){let i=[],r=[],s=[];ug(e),hg(i,e);let o=e.length;t.forEach(ug);for(let l=0;l<t.length;l++)r.push(o),o+=t[l].length,hg(i,t[l]);let a=Mu.triangulate(i,r);for(let l=0;l<a.length;l+=3)s.push(a.slice(l,l+3));return s}};function ug(n){let e=n.length;e>2&&n[e-1].equals(n[0])&&n.pop()}function hg(n,e){for(let t=0;t<e.length;t++)n.push(e[t].x),n.push(e[t].y)}var yu=class n extends Gt{constructor(e=new pr([new le(.5,.5),new le(-.5,.5),new le(-.5,-.5),new le(.5,-.5)]),t={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:e,options:t},e=Array.isArray(e)?e:[e];let i=this,r=[],s=[];for(let a=0,l=e.length;a<l;a++){let c=e[a];o(c)}this.setAttribute("position",new mt(r,3)),this.setAttribute("uv",new mt(s,2)),this.computeVertexNormals();function o(a){let l=[],c=t.curveSegments!==void 0?t.curveSegments:12,u=t.steps!==void 0?t.steps:1,h=t.depth!==void 0?t.depth:1,f=t.bevelEnabled!==void 0?t.bevelEnabled:!0,p=t.bevelThickness!==void 0?t.bevelThickness:.2,m=t.bevelSize!==void 0?t.bevelSize:p-.1,M=t.bevelOffset!==void 0?t.bevelOffset:0,d=t.bevelSegments!==void 0?t.bevelSegments:3,g=t.extrudePath,v=t.UVGenerator!==void 0?t.UVGenerator:kS,T,y=!1,C,A,x,w;if(g){T=g.getSpacedPoints(u),y=!0,f=!1;let se=g.isCatmullRomCurve3?g.closed:!1;C=g.computeFrenetFrames(u,se),A=new O,x=new O,w=new O}f||(d=0,p=0,m=0,M=0);let B=a.extractPoints(c),D=B.shape,L=B.holes;if(!jn.isClockWise(D)){D=D.reverse();for(let se=0,Me=L.length;se<Me;se++){let _e=L[se];jn.isClockWise(_e)&&(L[se]=_e.reverse())}}function W(se){let _e=10000000000000001e-36,Be=se[0];for(let Ie=1;Ie<=se.length;Ie++){let nt=Ie%se.length,ke=se[nt],gt=ke.x-Be.x,pt=ke.y-Be.y,yt=gt*gt+pt*pt,U=Math.max(Math.abs(ke.x),Math.abs(ke.y),Math.abs(Be.x),Math.abs(Be.y)),Se=_e*U*U;if(yt<=Se){se.splice(nt,1),Ie--;continue}Be=ke}}W(D),L.forEach(W);let I=L.length,H=D;for(let se=0;se<I;se++){let Me=L[se];D=D.concat(Me)}function q(se,Me,_e){return Me||bt("ExtrudeGeometry: vec does not exist"),se.clone().addScaledVector(Me,_e)}let G=D.length;function ce(se,Me,_e){let Be,Ie,nt,ke=se.x-Me.x,gt=se.y-Me.y,pt=_e.x-se.x,yt=_e.y-se.y,U=ke*ke+gt*gt,Se=ke*yt-gt*pt;if(Math.abs(Se)>Number.EPSILON){let qe=Math.sqrt(U),ht=Math.sqrt(pt*pt+yt*yt),Ee=Me.x-gt/qe,Nt=Me.y+ke/qe,Ke=_e.x-yt/ht,it=_e.y+pt/ht,R=((Ke-Ee)*yt-(it-Nt)*pt)/(ke*yt-gt*pt);Be=Ee+ke*R-se.x,Ie=Nt+gt*R-se.y;let S=Be*Be+Ie*Ie;if(S<=2)return new le(Be,Ie);nt=Math.sqrt(S/2)}else{let qe=!1;ke>Number.EPSILON?pt>Number.EPSILON&&(qe=!0):ke<-Number.EPSILON?pt<-Number.EPSILON&&(qe=!0):Math.sign(gt)===Math.sign(yt)&&(qe=!0),qe?(Be=-gt,Ie=ke,nt=Math.sqrt(U)):(Be=ke,Ie=gt,nt=Math.sqrt(U/2))}return new le(Be/nt,Ie/nt)}let K=[];for(let se=0,Me=H.length,_e=Me-1,Be=se+1;se<Me;se++,_e++,Be++)_e===Me&&(_e=0),Be===Me&&(Be=0),K[se]=ce(H[se],H[_e],H[Be]);let Q=[],ee,de=K.concat();for(let se=0,Me=I;se<Me;se++){let _e=L[se];ee=[];for(let Be=0,Ie=_e.length,nt=Ie-1,ke=Be+1;Be<Ie;Be++,nt++,ke++)nt===Ie&&(nt=0),ke===Ie&&(ke=0),ee[Be]=ce(_e[Be],_e[nt],_e[ke]);Q.push(ee),de=de.concat(ee)}let ue;if(d===0)ue=jn.triangulateShape(H,L);else{let se=[],Me=[];for(let _e=0;_e<d;_e++){let Be=_e/d,Ie=p*Math.cos(Be*Math.PI/2),nt=m*Math.sin(Be*Math.PI/2)+M;for(let ke=0,gt=H.length;ke<gt;ke++){let pt=q(H[ke],K[ke],nt);He(pt.x,pt.y,-Ie),Be===0&&se.push(pt)}for(let ke=0,gt=I;ke<gt;ke++){let pt=L[ke];ee=Q[ke];let yt=[];for(let U=0,Se=pt.length;U<Se;U++){let qe=q(pt[U],ee[U],nt);He(qe.x,qe.y,-Ie),Be===0&&yt.push(qe)}Be===0&&Me.push(yt)}}ue=jn.triangulateShape(se,Me)}let j=ue.length,xe=m+M;for(let se=0;se<G;se++){let Me=f?q(D[se],de[se],xe):D[se];y?(x.copy(C.normals[0]).multiplyScalar(Me.x),A.copy(C.binormals[0]).multiplyScalar(Me.y),w.copy(T[0]).add(x).add(A),He(w.x,w.y,w.z)):He(Me.x,Me.y,0)}for(let se=1;se<=u;se++)for(let Me=0;Me<G;Me++){let _e=f?q(D[Me],de[Me],xe):D[Me];y?(x.copy(C.normals[se]).multiplyScalar(_e.x),A.copy(C.binormals[se]).multiplyScalar(_e.y),w.copy(T[se]).add(x).add(A),He(w.x,w.y,w.z)):He(_e.x,_e.y,h/u*se)}for(let se=d-1;se>=0;se--){let Me=se/d,_e=p*Math.cos(Me*Math.PI/2),Be=m*Math.sin(Me*Math.PI/2)+M;for(let Ie=0,nt=H.length;Ie<nt;Ie++){let ke=q(H[Ie],K[Ie],Be);He(ke.x,ke.y,h+_e)}for(let Ie=0,nt=L.length;Ie<nt;Ie++){let ke=L[Ie];ee=Q[Ie];for(let gt=0,pt=ke.length;gt<pt;gt++){let yt=q(ke[gt],ee[gt],Be);y?He(yt.x,yt.y+T[u-1].y,T[u-1].x+_e):He(yt.x,yt.y,h+_e)}}}ve(),De();function ve(){let se=r.length/3;if(f){let Me=0,_e=G*Me;for(let Be=0;Be<j;Be++){let Ie=ue[Be];ot(Ie[2]+_e,Ie[1]+_e,Ie[0]+_e)}Me=u+d*2,_e=G*Me;for(let Be=0;Be<j;Be++){let Ie=ue[Be];ot(Ie[0]+_e,Ie[1]+_e,Ie[2]+_e)}}else{for(let Me=0;Me<j;Me++){let _e=ue[Me];ot(_e[2],_e[1],_e[0])}for(let Me=0;Me<j;Me++){let _e=ue[Me];ot(_e[0]+G*u,_e[1]+G*u,_e[2]+G*u)}}i.addGroup(se,r.length/3-se,0)}function De(){let se=r.length/3,Me=0;we(H,Me),Me+=H.length;for(let _e=0,Be=L.length;_e<Be;_e++){let Ie=L[_e];we(Ie,Me),Me+=Ie.length}i.addGroup(se,r.length/3-se,1)}function we(se,Me){let _e=se.length;for(;--_e>=0;){let Be=_e,Ie=_e-1;Ie<0&&(Ie=se.length-1);for(let nt=0,ke=u+d*2;nt<ke;nt++){let gt=G*nt,pt=G*(nt+1),yt=Me+Be+gt,U=Me+Ie+gt,Se=Me+Ie+pt,qe=Me+Be+pt;Je(yt,U,Se,qe)}}}function He(se,Me,_e){l.push(se),l.push(Me),l.push(_e)}function ot(se,Me,_e){at(se),at(Me),at(_e);let Be=r.length/3,Ie=v.generateTopUV(i,r,Be-3,Be-2,Be-1);rt(Ie[0]),rt(Ie[1]),rt(Ie[2])}function Je(se,Me,_e,Be){at(se),at(Me),at(Be),at(Me),at(_e),at(Be);let Ie=r.length/3,nt=v.generateSideWallUV(i,r,Ie-6,Ie-3,Ie-2,Ie-1);rt(nt[0]),rt(nt[1]),rt(nt[3]),rt(nt[1]),rt(nt[2]),rt(nt[3])}function at(se){r.push(l[se*3+0]),r.push(l[se*3+1]),r.push(l[se*3+2])}function rt(se){s.push(se.x),s.push(se.y)}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes,i=this.parameters.options;return zS(t,i,e)}static fromJSON(e,t){let i=[];for(let s=0,o=e.shapes.length;s<o;s++){let a=t[e.shapes[s]];i.push(a)}let r=e.options.extrudePath;return r!==void 0&&(e.options.extrudePath=new Ko[r.type]().fromJSON(r)),new n(i,e.options)}},kS={generateTopUV:function(n,e,t,i,r){let s=e[t*3],o=e[t*3+1],a=e[i*3],l=e[i*3+1],c=e[r*3],u=e[r*3+1];return[new le(s,o),new le(a,l),new le(c,u)]},generateSideWallUV:function(n,e,t,i,r,s){let o=e[t*3],a=e[t*3+1],l=e[t*3+2],c=e[i*3],u=e[i*3+1],h=e[i*3+2],f=e[r*3],p=e[r*3+1],m=e[r*3+2],M=e[s*3],d=e[s*3+1],g=e[s*3+2];return Math.abs(a-u)<Math.abs(o-c)?[new le(o,1-l),new le(c,1-h),new le(f,1-m),new le(M,1-g)]:[new le(a,1-l),new le(u,1-h),new le(p,1-m),new le(d,1-g)]}};function zS(n,e,t){if(t.shapes=[],Array.isArray(n))for(let i=0,r=n.length;i<r;i++){let s=n[i];t.shapes.push(s.uuid)}else t.shapes.push(n.uuid);return t.options=Object.assign({},e),e.extrudePath!==void 0&&(t.options.extrudePath=e.extrudePath.toJSON()),t}var Nn=class n extends Gt{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,u=l+1,h=e/a,f=t/l,p=[],m=[],M=[],d=[];for(let g=0;g<u;g++){let v=g*f-o;for(let T=0;T<c;T++){let y=T*h-s;m.push(y,-v,0),M.push(0,0,1),d.push(T/a),d.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let T=v+c*g,y=v+c*(g+1),C=v+1+c*(g+1),A=v+1+c*g;p.push(T,y,A),p.push(y,C,A)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(M,3)),this.setAttribute("uv",new mt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ss=class n extends Gt{constructor(e=.5,t=1,i=32,r=1,s=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:i,phiSegments:r,thetaStart:s,thetaLength:o},i=Math.max(3,i),r=Math.max(1,r);let a=[],l=[],c=[],u=[],h=e,f=(t-e)/r,p=new O,m=new le;for(let M=0;M<=r;M++){for(let d=0;d<=i;d++){let g=s+d/i*o;p.x=h*Math.cos(g),p.y=h*Math.sin(g),l.push(p.x,p.y,p.z),c.push(0,0,1),m.x=(p.x/t+1)/2,m.y=(p.y/t+1)/2,u.push(m.x,m.y)}h+=f}for(let M=0;M<r;M++){let d=M*(i+1);for(let g=0;g<i;g++){let v=g+d,T=v,y=v+i+1,C=v+i+2,A=v+1;a.push(T,y,A),a.push(y,C,A)}}this.setIndex(a),this.setAttribute("position",new mt(l,3)),this.setAttribute("normal",new mt(c,3)),this.setAttribute("uv",new mt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};var Su=class n extends Gt{constructor(e=new pr([new le(0,.5),new le(-.5,-.5),new le(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let i=[],r=[],s=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let u=0;u<e.length;u++)c(e[u]),this.addGroup(a,l,u),a+=l,l=0;this.setIndex(i),this.setAttribute("position",new mt(r,3)),this.setAttribute("normal",new mt(s,3)),this.setAttribute("uv",new mt(o,2));function c(u){let h=r.length/3,f=u.extractPoints(t),p=f.shape,m=f.holes;jn.isClockWise(p)===!1&&(p=p.reverse());for(let d=0,g=m.length;d<g;d++){let v=m[d];jn.isClockWise(v)===!0&&(m[d]=v.reverse())}let M=jn.triangulateShape(p,m);for(let d=0,g=m.length;d<g;d++){let v=m[d];p=p.concat(v)}for(let d=0,g=p.length;d<g;d++){let v=p[d];r.push(v.x,v.y,0),s.push(0,0,1),o.push(v.x,v.y)}for(let d=0,g=M.length;d<g;d++){let v=M[d],T=v[0]+h,y=v[1]+h,C=v[2]+h;i.push(T,y,C),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return GS(t,e)}static fromJSON(e,t){let i=[];for(let r=0,s=e.shapes.length;r<s;r++){let o=t[e.shapes[r]];i.push(o)}return new n(i,e.curveSegments)}};function GS(n,e){if(e.shapes=[],Array.isArray(n))for(let t=0,i=n.length;t<i;t++){let r=n[t];e.shapes.push(r.uuid)}else e.shapes.push(n.uuid);return e}var Jo=class n extends Gt{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new O,f=new O,p=[],m=[],M=[],d=[];for(let g=0;g<=i;g++){let v=[],T=g/i,y=o+T*a,C=e*Math.cos(y),A=Math.sqrt(e*e-C*C),x=0;g===0&&o===0?x=.5/t:g===i&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let B=w/t,D=r+B*s;h.x=-A*Math.cos(D),h.y=C,h.z=A*Math.sin(D),m.push(h.x,h.y,h.z),f.copy(h).normalize(),M.push(f.x,f.y,f.z),d.push(B+x,1-T),v.push(c++)}u.push(v)}for(let g=0;g<i;g++)for(let v=0;v<t;v++){let T=u[g][v+1],y=u[g][v],C=u[g+1][v],A=u[g+1][v+1];(g!==0||o>0)&&p.push(T,y,A),(g!==i-1||l<Math.PI)&&p.push(y,C,A)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(M,3)),this.setAttribute("uv",new mt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Ir(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(fg(r))r.isRenderTargetTexture?(Xe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(fg(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function qi(n){let e={};for(let t=0;t<n.length;t++){let i=Ir(n[t]);for(let r in i)e[r]=i[r]}return e}function fg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function pg(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function bu(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var dg={clone:Ir,merge:qi};var mg=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var gg=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var hi=class extends Fn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=mg,this.fragmentShader=gg,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ir(e.uniforms),this.uniformsGroups=pg(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new tt().setHex(r.value);break;case"v2":this.uniforms[i].value=new le().fromArray(r.value);break;case"v3":this.uniforms[i].value=new O().fromArray(r.value);break;case"v4":this.uniforms[i].value=new It().fromArray(r.value);break;case"m3":this.uniforms[i].value=new et().fromArray(r.value);break;case"m4":this.uniforms[i].value=new st().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var wu=class extends hi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var bn=class extends Fn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new tt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ll,this.normalScale=new le(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ln,this.combine=co,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Eu=class extends Fn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=vm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var Tu=class extends Fn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Qo=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new tt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var bl=class extends Qo{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new tt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var yf=new st,xg=new O,_g=new O,Au=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new le(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new st,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Qn,this._frameExtents=new le(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;xg.setFromMatrixPosition(e.matrixWorld),t.position.copy(xg),_g.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(_g),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){yf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(yf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===Tr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(yf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Ru=new O,Cu=new Ii,dr=new O,jo=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new st,this.projectionMatrix=new st,this.projectionMatrixInverse=new st,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ru,Cu,dr),dr.x===1&&dr.y===1&&dr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ru,Cu,dr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Ru,Cu,dr),dr.x===1&&dr.y===1&&dr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ru,Cu,dr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var os=new O,vg=new le,Mg=new le,Ui=class extends jo{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=cl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(zc*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return cl*2*Math.atan(Math.tan(zc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(os.x,os.y).multiplyScalar(-e/os.z),os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(os.x,os.y).multiplyScalar(-e/os.z)}getViewSize(e,t){return this.getViewBounds(e,vg,Mg),t.subVectors(Mg,vg)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(zc*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ea=class extends jo{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Pu=class extends Au{constructor(){super(new ea(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var wl=class extends Qo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new Pu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var ta=-90,ia=1,Us=class extends Qt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Ui(ta,ia,e,t);r.layers=this.layers,this.add(r);let s=new Ui(ta,ia,e,t);s.layers=this.layers,this.add(s);let o=new Ui(ta,ia,e,t);o.layers=this.layers,this.add(o);let a=new Ui(ta,ia,e,t);a.layers=this.layers,this.add(a);let l=new Ui(ta,ia,e,t);l.layers=this.layers,this.add(l);let c=new Ui(ta,ia,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Tr)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=M,e.setRenderTarget(i,5,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}};var Lu=class extends Ui{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};function Sf(n,e,t,i){let r=HS(i);switch(t){case Fc:return n*e;case mo:return n*e/r.components*r.byteLength;case go:return n*e/r.components*r.byteLength;case xn:return n*e*2/r.components*r.byteLength;case xo:return n*e*2/r.components*r.byteLength;case Uc:return n*e*3/r.components*r.byteLength;case Hi:return n*e*4/r.components*r.byteLength;case _o:return n*e*4/r.components*r.byteLength;case vo:case Mo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case yo:case So:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ia:case Ua:return Math.max(n,16)*Math.max(e,8)/4;case Da:case Fa:return Math.max(n,8)*Math.max(e,8)/2;case Na:case Oa:case ka:case za:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ba:case Ss:case Ga:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ha:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Va:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Wa:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Xa:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case qa:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ya:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case $a:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ka:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Za:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ja:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Qa:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ja:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case el:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case tl:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case il:case nl:case rl:return Math.ceil(n/4)*Math.ceil(e/4)*16;case sl:case ol:return Math.ceil(n/4)*Math.ceil(e/4)*8;case bs:case al:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function HS(n){switch(n){case ui:case Pc:return{byteLength:1,components:1};case Er:case Lc:case Di:return{byteLength:2,components:1};case fo:case po:return{byteLength:2,components:4};case Li:case ho:case bi:return{byteLength:4,components:1};case Dc:case Ic:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Xe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Du(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function yg(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<h.length;p++){let m=h[f],M=h[p];M.start<=m.start+m.count+1?m.count=Math.max(m.count,M.start+M.count-m.start):(++f,h[f]=M)}h.length=f+1;for(let p=0,m=h.length;p<m;p++){let M=h[p];n.bufferSubData(c,M.start*u.BYTES_PER_ELEMENT,u,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var Sg=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var bg=`
#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value ) {
return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
}
float hash3D( vec3 value ) {
return hash2D( vec2( hash2D( value.xy ), value.z ) );
}
float getAlphaHashThreshold( vec3 position ) {
float maxDeriv = max(
length( dFdx( position.xyz ) ),
length( dFdy( position.xyz ) )
);
float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
vec2 pixScales = vec2(
exp2( floor( log2( pixScale ) ) ),
exp2( ceil( log2( pixScale ) ) )
);
vec2 alpha = vec2(
hash3D( floor( pixScales.x * position.xyz ) ),
hash3D( floor( pixScales.y * position.xyz ) )
);
float lerpFactor = fract( log2( pixScale ) );
float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
float a = min( lerpFactor, 1.0 - lerpFactor );
vec3 cases = vec3(
x * x / ( 2.0 * a * ( 1.0 - a ) ),
( x - 0.5 * a ) / ( 1.0 - a ),
1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
);
float threshold = ( x < ( 1.0 - a ) )
? ( ( x < a ) ? cases.x : cases.y )
: cases.z;
return clamp( threshold , 1.0e-6, 1.0 );
}
#endif
`;var wg=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Eg=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Tg=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var Ag=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var Rg=`
#ifdef USE_AOMAP
float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
reflectedLight.indirectDiffuse *= ambientOcclusion;
#if defined( USE_CLEARCOAT )
clearcoatSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_SHEEN )
sheenSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
#endif
#endif
`;var Cg=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var Pg=`
#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i ) {
int size = textureSize( batchingTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
float getIndirectIndex( const in int i ) {
int size = textureSize( batchingIdTexture, 0 ).x;
int x = i % size;
int y = i / size;
return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
}
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i ) {
int size = textureSize( batchingColorTexture, 0 ).x;
int j = int( i );
int x = j % size;
int y = j / size;
return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
}
#endif
`;var Lg=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Dg=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var Ig=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var Fg=`
float G_BlinnPhong_Implicit( ) {
return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( specularColor, 1.0, dotVH );
float G = G_BlinnPhong_Implicit( );
float D = D_BlinnPhong( shininess, dotNH );
return F * ( G * D );
}
`;var Ug="";var Ng=`
#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd() {
vec2 dSTdx = dFdx( vBumpMapUv );
vec2 dSTdy = dFdy( vBumpMapUv );
float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
return vec2( dBx, dBy );
}
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
vec3 vN = surf_norm;
vec3 R1 = cross( vSigmaY, vN );
vec3 R2 = cross( vN, vSigmaX );
float fDet = dot( vSigmaX, R1 ) * faceDirection;
vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
return normalize( abs( fDet ) * surf_norm - vGrad );
}
#endif
`;var Og=`
#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float distanceToPlane, distanceGradient;
float clipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
if ( clipOpacity == 0.0 ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
}
#pragma unroll_loop_end
clipOpacity *= 1.0 - unionClipOpacity;
#endif
diffuseColor.a *= clipOpacity;
if ( diffuseColor.a == 0.0 ) discard;
#else
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped = true;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
}
#pragma unroll_loop_end
if ( clipped ) discard;
#endif
#endif
#endif
`;var Bg=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var kg=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var zg=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Gg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Hg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Vg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var Wg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
vColor *= color;
#elif defined( USE_COLOR )
vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif
`;var Xg=`
#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
const highp float a = 12.9898, b = 78.233, c = 43758.5453;
highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v ) { return length( v ); }
#else
float precisionSafeLength( vec3 v ) {
float maxComponent = max3( abs( v ) );
return length( v / maxComponent ) * maxComponent;
}
#endif
struct IncidentLight {
vec3 color;
vec3 direction;
bool visible;
};
struct ReflectedLight {
vec3 directDiffuse;
vec3 directSpecular;
vec3 indirectDiffuse;
vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
`;var qg=`
vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
mat3 bm = mat3( batchingMatrix );
transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
transformedNormal = bm * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = bm * transformedTangent;
#endif
#endif
#ifdef USE_INSTANCING
mat3 im = mat3( instanceMatrix );
transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
transformedNormal = im * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = im * transformedTangent;
#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif
`;var Yg=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var $g=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var Kg=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var Zg=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var Jg=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var Qg=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var jg=`
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
if ( isOrthographic ) {
cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToFrag = normalize( vWorldPosition - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec = reflect( cameraToFrag, worldNormal );
#else
vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
#endif
#else
vec3 reflectVec = vReflect;
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
#ifdef ENVMAP_BLENDING_MULTIPLY
outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_MIX )
outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_ADD )
outgoingLight += envColor.xyz * specularStrength * reflectivity;
#endif
#endif
#endif
`;var e0=`
#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness ) {
float r = clamp( roughness, 0.0, 1.0 );
return ENVMAP_MAX_LOD * r * ( 2.0 - r );
}
#endif
#endif
`;var t0=`
#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif
`;var i0=`
#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif
`;var n0=`
#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vWorldPosition = worldPosition.xyz;
#else
vec3 cameraToVertex;
if ( isOrthographic ) {
cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vReflect = reflect( cameraToVertex, worldNormal );
#else
vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
#endif
#endif
#endif
`;var r0=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var s0=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var o0=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var a0=`
#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif
`;var l0=`
#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
float dotNL = dot( normal, lightDirection );
vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
#ifdef USE_GRADIENTMAP
return vec3( texture2D( gradientMap, coord ).r );
#else
vec2 fw = fwidth( coord ) * 0.5;
return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
#endif
}
`;var c0=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var u0=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var h0=`
varying vec3 vViewPosition;
struct LambertMaterial {
vec3 diffuseColor;
float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct RE_Direct_Lambert
#define RE_IndirectDiffuse RE_IndirectDiffuse_Lambert
`;var f0=`
uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
float x = normal.x, y = normal.y, z = normal.z;
vec3 result = shCoefficients[ 0 ] * 0.886227;
result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
vec3 irradiance = ambientLightColor;
return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
if ( cutoffDistance > 0.0 ) {
distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
}
return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
struct SunLight {
vec3 direction;
vec3 color;
};
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
light.color = sunLight.color;
light.direction = sunLight.direction;
light.visible = true;
}
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight {
vec3 direction;
vec3 color;
};
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
light.color = directionalLight.color;
light.direction = directionalLight.direction;
light.visible = true;
}
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight {
vec3 position;
vec3 color;
float distance;
float decay;
};
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = pointLight.position - geometryPosition;
light.direction = normalize( lVector );
float lightDistance = length( lVector );
light.color = pointLight.color;
light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
}
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight {
vec3 position;
vec3 direction;
vec3 color;
float distance;
float decay;
float coneCos;
float penumbraCos;
};
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = spotLight.position - geometryPosition;
light.direction = normalize( lVector );
float angleCos = dot( light.direction, spotLight.direction );
float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
if ( spotAttenuation > 0.0 ) {
float lightDistance = length( lVector );
light.color = spotLight.color * spotAttenuation;
light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
} else {
light.color = vec3( 0.0 );
light.visible = false;
}
}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight {
vec3 color;
vec3 position;
vec3 halfWidth;
vec3 halfHeight;
};
uniform sampler2D ltc_1;
uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight {
vec3 direction;
vec3 skyColor;
vec3 groundColor;
};
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
float dotNL = dot( normal, hemiLight.direction );
float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
return irradiance;
}
#endif
#include <lightprobes_pars_fragment>
`;var p0="";var d0="";var m0="";var g0="";var x0="";var _0="";var v0="";var M0=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
float dotNVi = saturate( dot( normal, geometryViewDir ) );
if ( material.iridescenceThickness == 0.0 ) {
material.iridescence = 0.0;
} else {
material.iridescence = saturate( material.iridescence );
}
if ( material.iridescence > 0.0 ) {
vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
}
#endif
#ifdef STANDARD
float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs = material.dfg.x + material.dfg.y;
material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
pointLight = pointLights[ i ];
getPointLightInfo( pointLight, geometryPosition, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
pointLightShadow = pointLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
spotLight = spotLights[ i ];
getSpotLightInfo( spotLight, geometryPosition, directLight );
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
spotLightShadow = spotLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
sunLight = sunLights[ i ];
getSunLightInfo( sunLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
sunLightShadow = sunLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
directionalLight = directionalLights[ i ];
getDirectionalLightInfo( directionalLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
directionalLightShadow = directionalLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
rectAreaLight = rectAreaLights[ i ];
RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance = vec3( 0.0 );
vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
#if defined( USE_LIGHT_PROBES )
irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
#pragma unroll_loop_start
for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
}
#pragma unroll_loop_end
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
int probeGrid = - 1;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
}
#pragma unroll_loop_end
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
}
#pragma unroll_loop_end
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance = vec3( 0.0 );
vec3 clearcoatRadiance = vec3( 0.0 );
#endif
`;var y0=`
#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
irradiance += lightMapIrradiance;
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
iblIrradiance += getIBLIrradiance( geometryNormal );
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
#endif
radiance += iblRadiance;
#ifdef USE_CLEARCOAT
clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
#endif
#endif
`;var S0=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var b0=`
#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
vec3 spacing = ( probesMax - probesMin ) / probesResolution;
vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
vec3 margin = spacing * 0.01;
return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
vec3 res = probesResolution;
vec3 gridRange = probesMax - probesMin;
vec3 probeSpacing = gridRange / res;
vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
float nz = res.z;
float paddedSlices = nz + 2.0;
float atlasDepth = 7.0 * paddedSlices;
float uvZBase = uvw.z * nz + 1.0;
vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase ) / atlasDepth ) );
vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase + paddedSlices ) / atlasDepth ) );
vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices ) / atlasDepth ) );
vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices ) / atlasDepth ) );
vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices ) / atlasDepth ) );
vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices ) / atlasDepth ) );
vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices ) / atlasDepth ) );
vec3 c0 = s0.xyz;
vec3 c1 = vec3( s0.w, s1.xy );
vec3 c2 = vec3( s1.zw, s2.x );
vec3 c3 = s2.yzw;
vec3 c4 = s3.xyz;
vec3 c5 = vec3( s3.w, s4.xy );
vec3 c6 = vec3( s4.zw, s5.x );
vec3 c7 = s5.yzw;
vec3 c8 = s6.xyz;
float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
vec3 result = c0 * 0.886227;
result += c1 * 2.0 * 0.511664 * y;
result += c2 * 2.0 * 0.511664 * z;
result += c3 * 2.0 * 0.511664 * x;
result += c4 * 2.0 * 0.429043 * x * y;
result += c5 * 2.0 * 0.429043 * y * z;
result += c6 * ( 0.743125 * z * z - 0.247708 );
result += c7 * 2.0 * 0.429043 * x * z;
result += c8 * 0.429043 * ( x * x - y * y );
return max( result, vec3( 0.0 ) );
}
#endif
`;var w0=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var E0=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var T0=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var A0=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var R0=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var C0=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var P0=`
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv = vUv;
#else
vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
#endif
#endif
#ifdef USE_MAP
diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif
`;var L0=`
#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var D0=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var I0=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var F0=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] = texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var U0=`
#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
vColor *= morphTargetBaseInfluence;
#elif defined( USE_COLOR )
vColor.rgb *= morphTargetBaseInfluence;
#endif
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
#if defined( USE_COLOR_ALPHA )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
#elif defined( USE_COLOR )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
#endif
}
#endif
`;var N0=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var O0=`
#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
int y = texelIndex / morphTargetsTextureSize.x;
int x = texelIndex - y * morphTargetsTextureSize.x;
ivec3 morphUV = ivec3( x, y, morphTargetIndex );
return texelFetch( morphTargetsTexture, morphUV, 0 );
}
#endif
`;var B0=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var k0=`
float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
vec3 fdx = dFdx( vViewPosition );
vec3 fdy = dFdy( vViewPosition );
vec3 normal = normalize( cross( fdx, fdy ) );
#else
vec3 normal = normalize( vNormal );
#ifdef DOUBLE_SIDED
normal *= faceDirection;
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn = getTangentFrame( - vViewPosition, normal,
#if defined( USE_NORMALMAP )
vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
vClearcoatNormalMapUv
#else
vUv
#endif
);
#endif
#ifdef DOUBLE_SIDED
tbn[0] *= faceDirection;
tbn[1] *= faceDirection;
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
#endif
#ifdef DOUBLE_SIDED
tbn2[0] *= faceDirection;
tbn2[1] *= faceDirection;
#endif
#endif
vec3 nonPerturbedNormal = normal;
`;var z0=`
#ifdef USE_NORMALMAP_OBJECTSPACE
normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#ifdef FLIP_SIDED
normal = - normal;
#endif
#ifdef DOUBLE_SIDED
normal = normal * faceDirection;
#endif
normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#if defined( USE_PACKED_NORMALMAP )
mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
#endif
mapN.xy *= normalScale;
normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif
`;var G0=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var H0=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var V0=`
#ifndef FLAT_SHADED
vNormal = normalize( transformedNormal );
#ifdef USE_TANGENT
vTangent = normalize( transformedTangent );
vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
#ifdef FLIP_SIDED
vBitangent = - vBitangent;
#endif
#endif
#endif
`;var W0=`
#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
vec3 q0 = dFdx( eye_pos.xyz );
vec3 q1 = dFdy( eye_pos.xyz );
vec2 st0 = dFdx( uv.st );
vec2 st1 = dFdy( uv.st );
vec3 N = surf_norm;
vec3 q1perp = cross( q1, N );
vec3 q0perp = cross( N, q0 );
vec3 T = q1perp * st0.x + q0perp * st1.x;
vec3 B = q1perp * st0.y + q0perp * st1.y;
float det = max( dot( T, T ), dot( B, B ) );
float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
return mat3( T * scale, B * scale, N );
}
#endif
`;var X0="";var q0="";var Y0="";var $0="";var K0=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var Z0=`
vec3 packNormalToRGB( const in vec3 normal ) {
return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;
const float UnpackDownscale = 255. / 256.;
const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
if( v <= 0.0 )
return vec4( 0., 0., 0., 0. );
if( v >= 1.0 )
return vec4( 1., 1., 1., 1. );
float vuf;
float af = modf( v * PackFactors.a, vuf );
float bf = modf( vuf * ShiftRight8, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
if( v <= 0.0 )
return vec3( 0., 0., 0. );
if( v >= 1.0 )
return vec3( 1., 1., 1. );
float vuf;
float bf = modf( v * PackFactors.b, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
if( v <= 0.0 )
return vec2( 0., 0. );
if( v >= 1.0 )
return vec2( 1., 1. );
float vuf;
float gf = modf( v * 256., vuf );
return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER
return depth * ( far - near ) - far;
#else
return depth * ( near - far ) - near;
#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER
return ( near * far ) / ( ( near - far ) * depth - near );
#else
return ( near * far ) / ( ( far - near ) * depth - far );
#endif
}
`;var J0=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var Q0=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var j0=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var ex=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var tx=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var ix=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var nx=`
#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position ) {
return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
}
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
const float goldenAngle = 2.399963229728653;
float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
float theta = float( sampleIndex ) * goldenAngle + phi;
return vec2( cos( theta ), sin( theta ) ) * r;
}
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
vec2 radius = shadowRadius * texelSize;
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = (
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
) * 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
float mean = distribution.x;
float variance = distribution.y * distribution.y;
#ifdef USE_REVERSED_DEPTH_BUFFER
float hard_shadow = step( mean, shadowCoord.z );
#else
float hard_shadow = step( shadowCoord.z, mean );
#endif
if ( hard_shadow == 1.0 ) {
shadow = 1.0;
} else {
variance = max( variance, 0.0000001 );
float d = shadowCoord.z - mean;
float p_max = variance / ( variance + d * d );
p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
shadow = max( hard_shadow, p_max );
}
}
return mix( 1.0, shadow, shadowIntensity );
}
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
float depth = texture2D( shadowMap, shadowCoord.xy ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadow = step( depth, shadowCoord.z );
#else
shadow = step( shadowCoord.z, depth );
#endif
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow,
int shadowIndex
) {
vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
float viewDepth = vSunShadowWorldPosition.w;
int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
float shadow = 1.0;
for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
float cascadeShadow = getShadow(
shadowMap,
sunLightShadow.shadowMapSize,
sunLightShadow.shadowIntensity,
sunLightShadow.shadowBias,
sunLightShadow.shadowRadius,
sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
);
shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
}
}
return shadow;
}
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 bd3D = normalize( lightToPosition );
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float lightDistance = length( lightToPosition );
float depthRange = shadowCameraFar - shadowCameraNear;
#ifdef USE_REVERSED_DEPTH_BUFFER
float depthA = - shadowCameraNear / depthRange - shadowBias;
float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#else
float depthA = shadowCameraFar / depthRange + shadowBias;
float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#endif
float texelSize = shadowRadius / shadowMapSize.x;
vec3 absDir = abs( bd3D );
vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
tangent = normalize( cross( bd3D, tangent ) );
vec3 bitangent = cross( bd3D, tangent );
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = 0.0;
for ( int i = 0; i < 5; i ++ ) {
vec2 offset = vogelDiskSample( i, 5, phi );
vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
vec3 absDirection = abs( direction );
float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
shadow += texture( shadowMap, vec4( direction, dp ) );
}
shadow *= 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
dp += shadowBias;
vec3 bd3D = normalize( lightToPosition );
float depth = textureCube( shadowMap, bd3D ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
depth = 1.0 - depth;
#endif
shadow = step( dp, depth );
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#endif
#endif
`;var rx=`
#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif
`;var sx=`
#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#else
vec3 shadowWorldNormal = vec3( 0.0 );
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
vSunShadowWorldNormal = shadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
shadowWorldPosition = worldPosition;
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
#endif
vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
`;var ox=`
float getShadowMask() {
float shadow = 1.0;
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
sunLight = sunLightShadows[ i ];
shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
directionalLight = directionalLightShadows[ i ];
shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
spotLight = spotLightShadows[ i ];
shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
PointLightShadow pointLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
pointLight = pointLightShadows[ i ];
shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
}
#pragma unroll_loop_end
#endif
#endif
return shadow;
}
`;var ax=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var lx=`
#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i ) {
int size = textureSize( boneTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
#endif
`;var cx=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var ux=`
#ifdef USE_SKINNING
mat4 skinMatrix = mat4( 0.0 );
skinMatrix += skinWeight.x * boneMatX;
skinMatrix += skinWeight.y * boneMatY;
skinMatrix += skinWeight.z * boneMatZ;
skinMatrix += skinWeight.w * boneMatW;
skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
#ifdef USE_TANGENT
objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
#endif
#endif
`;var hx=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var fx=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var px=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var dx=`
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
color *= toneMappingExposure;
return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
color *= toneMappingExposure;
color = max( vec3( 0.0 ), color - 0.004 );
return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
const mat3 ACESInputMat = mat3(
vec3( 0.59719, 0.07600, 0.02840 ),
vec3( 0.35458, 0.90834, 0.13383 ),
vec3( 0.04823, 0.01566, 0.83777 )
);
const mat3 ACESOutputMat = mat3(
vec3( 1.60475, -0.10208, -0.00327 ),
vec3( -0.53108, 1.10813, -0.07276 ),
vec3( -0.07367, -0.00605, 1.07602 )
);
color *= toneMappingExposure / 0.6;
color = ACESInputMat * color;
color = RRTAndODTFit( color );
color = ACESOutputMat * color;
return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
vec3( 1.6605, - 0.1246, - 0.0182 ),
vec3( - 0.5876, 1.1329, - 0.1006 ),
vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
vec3( 0.6274, 0.0691, 0.0164 ),
vec3( 0.3293, 0.9195, 0.0880 ),
vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
vec3 x2 = x * x;
vec3 x4 = x2 * x2;
return + 15.5 * x4 * x2
- 40.14 * x4 * x
+ 31.96 * x4
- 6.868 * x2 * x
+ 0.4298 * x2
+ 0.1191 * x
- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
const mat3 AgXInsetMatrix = mat3(
vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
);
const mat3 AgXOutsetMatrix = mat3(
vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
);
const float AgxMinEv = - 12.47393;
const float AgxMaxEv = 4.026069;
color *= toneMappingExposure;
color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
color = AgXInsetMatrix * color;
color = max( color, 1e-10 );
color = log2( color );
color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
color = clamp( color, 0.0, 1.0 );
color = agxDefaultContrastApprox( color );
color = AgXOutsetMatrix * color;
color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
color = clamp( color, 0.0, 1.0 );
return color;
}
vec3 NeutralToneMapping( vec3 color ) {
const float StartCompression = 0.8 - 0.04;
const float Desaturation = 0.15;
color *= toneMappingExposure;
float x = min( color.r, min( color.g, color.b ) );
float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
color -= offset;
float peak = max( color.r, max( color.g, color.b ) );
if ( peak < StartCompression ) return color;
float d = 1. - StartCompression;
float newPeak = 1. - d * d / ( peak + d - StartCompression );
color *= newPeak / peak;
float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }
`;var mx="";var gx="";var xx=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
`;var _x=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif
`;var vx=`
#if defined( USE_UV ) || defined( USE_ANISOTROPY )
vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif
`;var Mx=`
#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
worldPosition = batchingMatrix * worldPosition;
#endif
#ifdef USE_INSTANCING
worldPosition = instanceMatrix * worldPosition;
#endif
worldPosition = modelMatrix * worldPosition;
#endif
`;var yx=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,Sx=`
uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
vec4 texColor = texture2D( t2D, vUv );
#ifdef DECODE_VIDEO_TEXTURE
texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var bx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,wx=`
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
#ifdef ENVMAP_TYPE_PMREM
vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
#else
vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var Ex=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Tx=`
uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
gl_FragColor = texColor;
gl_FragColor.a *= opacity;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var Ax=`
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vHighPrecisionZW = gl_Position.zw;
}
`,Rx=`
#if DEPTH_PACKING == 3200
uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#if DEPTH_PACKING == 3200
diffuseColor.a = opacity;
#endif
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <logdepthbuf_fragment>
#ifdef USE_REVERSED_DEPTH_BUFFER
float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
#else
float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
#endif
#if DEPTH_PACKING == 3200
gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
#elif DEPTH_PACKING == 3201
gl_FragColor = packDepthToRGBA( fragCoordZ );
#elif DEPTH_PACKING == 3202
gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
#elif DEPTH_PACKING == 3203
gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
#endif
}
`;var Cx=`
#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <worldpos_vertex>
#include <clipping_planes_vertex>
vWorldPosition = worldPosition.xyz;
}
`,Px=`
#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
float dist = length( vWorldPosition - referencePosition );
dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
dist = saturate( dist );
gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}
`;var Lx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,Dx=`
uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
vec3 direction = normalize( vWorldDirection );
vec2 sampleUV = equirectUv( direction );
gl_FragColor = texture2D( tEquirect, sampleUV );
#include <tonemapping_fragment>
#include <colorspace_fragment>
}
`;var Ix=`
uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
vLineDistance = scale * lineDistance;
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}
`,Fx=`
uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
if ( mod( vLineDistance, totalSize ) > dashSize ) {
discard;
}
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var Ux=`
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <envmap_vertex>
#include <fog_vertex>
}
`,Nx=`
uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
#else
reflectedLight.indirectDiffuse += vec3( 1.0 );
#endif
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= diffuseColor.rgb;
vec3 outgoingLight = reflectedLight.indirectDiffuse;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var Ox=`
#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,Bx=`
#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_lambert_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
`;var kx=`
#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
vViewPosition = - mvPosition.xyz;
#endif
}
`,zx=`
#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
#ifdef OPAQUE
gl_FragColor.a = 1.0;
#endif
}
`;var Gx=`
uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
varying vec2 vUv;
uniform mat3 uvTransform;
#endif
void main() {
#ifdef USE_POINTS_UV
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
#endif
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
gl_PointSize = size;
#ifdef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
#endif
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <fog_vertex>
}
`,Hx=`
uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_particle_fragment>
#include <color_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var Vx=`
#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}
`,Wx=`
uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
#include <logdepthbuf_fragment>
gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}
`;var Xx=`
uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
vec4 mvPosition = modelViewMatrix[ 3 ];
vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
#ifndef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) scale *= - mvPosition.z;
#endif
vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
vec2 rotatedPosition;
rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
mvPosition.xy += rotatedPosition;
gl_Position = projectionMatrix * mvPosition;
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}
`,qx=`
uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
}
`;var vt={alphahash_fragment:Sg,alphahash_pars_fragment:bg,alphamap_fragment:wg,alphamap_pars_fragment:Eg,alphatest_fragment:Tg,alphatest_pars_fragment:Ag,aomap_fragment:Rg,aomap_pars_fragment:Cg,batching_pars_vertex:Pg,batching_vertex:Lg,begin_vertex:Dg,beginnormal_vertex:Ig,bsdfs:Fg,iridescence_fragment:Ug,bumpmap_pars_fragment:Ng,clipping_planes_fragment:Og,clipping_planes_pars_fragment:Bg,clipping_planes_pars_vertex:kg,clipping_planes_vertex:zg,color_fragment:Gg,color_pars_fragment:Hg,color_pars_vertex:Vg,color_vertex:Wg,common:Xg,defaultnormal_vertex:qg,displacementmap_pars_vertex:Yg,displacementmap_vertex:$g,emissivemap_fragment:Kg,emissivemap_pars_fragment:Zg,colorspace_fragment:Jg,colorspace_pars_fragment:Qg,envmap_fragment:jg,envmap_common_pars_fragment:e0,envmap_pars_fragment:t0,envmap_pars_vertex:i0,envmap_physical_pars_fragment:p0,envmap_vertex:n0,fog_vertex:r0,fog_pars_vertex:s0,fog_fragment:o0,fog_pars_fragment:a0,gradientmap_pars_fragment:l0,lightmap_pars_fragment:c0,lights_lambert_fragment:u0,lights_lambert_pars_fragment:h0,lights_pars_begin:f0,lights_toon_fragment:d0,lights_toon_pars_fragment:m0,lights_phong_fragment:g0,lights_phong_pars_fragment:x0,lights_physical_fragment:_0,lights_physical_pars_fragment:v0,lights_fragment_begin:M0,lights_fragment_maps:y0,lights_fragment_end:S0,lightprobes_pars_fragment:b0,logdepthbuf_fragment:w0,logdepthbuf_pars_fragment:E0,logdepthbuf_pars_vertex:T0,logdepthbuf_vertex:A0,map_fragment:R0,map_pars_fragment:C0,map_particle_fragment:P0,map_particle_pars_fragment:L0,metalnessmap_fragment:D0,metalnessmap_pars_fragment:I0,morphinstance_vertex:F0,morphcolor_vertex:U0,morphnormal_vertex:N0,morphtarget_pars_vertex:O0,morphtarget_vertex:B0,normal_fragment_begin:k0,normal_fragment_maps:z0,normal_pars_fragment:G0,normal_pars_vertex:H0,normal_vertex:V0,normalmap_pars_fragment:W0,clearcoat_normal_fragment_begin:X0,clearcoat_normal_fragment_maps:q0,clearcoat_pars_fragment:Y0,iridescence_pars_fragment:$0,opaque_fragment:K0,packing:Z0,premultiplied_alpha_fragment:J0,project_vertex:Q0,dithering_fragment:j0,dithering_pars_fragment:ex,roughnessmap_fragment:tx,roughnessmap_pars_fragment:ix,shadowmap_pars_fragment:nx,shadowmap_pars_vertex:rx,shadowmap_vertex:sx,shadowmask_pars_fragment:ox,skinbase_vertex:ax,skinning_pars_vertex:lx,skinning_vertex:cx,skinnormal_vertex:ux,specularmap_fragment:hx,specularmap_pars_fragment:fx,tonemapping_fragment:px,tonemapping_pars_fragment:dx,transmission_fragment:mx,transmission_pars_fragment:gx,uv_pars_fragment:xx,uv_pars_vertex:_x,uv_vertex:vx,worldpos_vertex:Mx,background_vert:yx,background_frag:Sx,backgroundCube_vert:bx,backgroundCube_frag:wx,cube_vert:Ex,cube_frag:Tx,depth_vert:Ax,depth_frag:Rx,distance_vert:Cx,distance_frag:Px,equirect_vert:Lx,equirect_frag:Dx,linedashed_vert:Ix,linedashed_frag:Fx,meshbasic_vert:Ux,meshbasic_frag:Nx,meshlambert_vert:Ox,meshlambert_frag:Bx,meshmatcap_vert:"",meshmatcap_frag:"",meshnormal_vert:kx,meshnormal_frag:zx,meshphong_vert:"",meshphong_frag:"",meshphysical_vert:"",meshphysical_frag:"",meshtoon_vert:"",meshtoon_frag:"",points_vert:Gx,points_frag:Hx,shadow_vert:Vx,shadow_frag:Wx,sprite_vert:Xx,sprite_frag:qx};var Ne={common:{diffuse:{value:new tt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new le(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new tt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new tt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new tt(16777215)},opacity:{value:1},center:{value:new le(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}};var On={basic:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:vt.meshbasic_vert,fragmentShader:vt.meshbasic_frag},lambert:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},envMapIntensity:{value:1}}]),vertexShader:vt.meshlambert_vert,fragmentShader:vt.meshlambert_frag},phong:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},specular:{value:new tt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:vt.meshphong_vert,fragmentShader:vt.meshphong_frag},standard:{uniforms:qi([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag},toon:{uniforms:qi([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)}}]),vertexShader:vt.meshtoon_vert,fragmentShader:vt.meshtoon_frag},matcap:{uniforms:qi([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:vt.meshmatcap_vert,fragmentShader:vt.meshmatcap_frag},points:{uniforms:qi([Ne.points,Ne.fog]),vertexShader:vt.points_vert,fragmentShader:vt.points_frag},dashed:{uniforms:qi([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:vt.linedashed_vert,fragmentShader:vt.linedashed_frag},depth:{uniforms:qi([Ne.common,Ne.displacementmap]),vertexShader:vt.depth_vert,fragmentShader:vt.depth_frag},normal:{uniforms:qi([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:vt.meshnormal_vert,fragmentShader:vt.meshnormal_frag},sprite:{uniforms:qi([Ne.sprite,Ne.fog]),vertexShader:vt.sprite_vert,fragmentShader:vt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:vt.background_vert,fragmentShader:vt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:vt.backgroundCube_vert,fragmentShader:vt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:vt.cube_vert,fragmentShader:vt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:vt.equirect_vert,fragmentShader:vt.equirect_frag},distance:{uniforms:qi([Ne.common,Ne.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:vt.distance_vert,fragmentShader:vt.distance_frag},shadow:{uniforms:qi([Ne.lights,Ne.fog,{color:{value:new tt(0)},opacity:{value:1}}]),vertexShader:vt.shadow_vert,fragmentShader:vt.shadow_frag}};On.physical={uniforms:qi([On.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new le(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new tt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new le},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new tt(0)},specularColor:{value:new tt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new le},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag};var Iu={r:0,b:0,g:0},ib=new st,Yx=new et;Yx.set(-1,0,0,0,1,0,0,0,1);function $x(n,e,t,i,r,s){let o=new tt(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function p(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let y=v.backgroundBlurriness>0;T=e.get(T,y)}return T}function m(v){let T=!1,y=p(v);y===null?d(o,a):y&&y.isColor&&(d(y,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,s):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(v,T){let y=p(T);y&&y.isCubeTexture?(c===void 0&&(c=new At(new ns(1,1,1),new hi({name:"BackgroundCubeMaterial",uniforms:Ir(On.backgroundCube.uniforms),vertexShader:On.backgroundCube.vertexShader,fragmentShader:On.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ib.makeRotationFromEuler(T.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yx),c.material.toneMapped=_t.getTransfer(y.colorSpace)!==Pt,(u!==y||h!==y.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=y,h=y.version,f=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new At(new Nn(2,2),new hi({name:"BackgroundMaterial",uniforms:Ir(On.background.uniforms),vertexShader:On.background.vertexShader,fragmentShader:On.background.fragmentShader,side:Rn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=_t.getTransfer(y.colorSpace)!==Pt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||h!==y.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=y,h=y.version,f=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function d(v,T){v.getRGB(Iu,bu(n)),t.buffers.color.setClear(Iu.r,Iu.g,Iu.b,T,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:m,addToRenderList:M,dispose:g}}function Kx(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(L,z,W,I,H){let q=!1,G=h(L,I,W,z);s!==G&&(s=G,c(s.object)),q=p(L,I,W,H),q&&m(L,I,W,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,y(L,z,W,I),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,z,W,I){let H=I.wireframe===!0,q=i[z.id];q===void 0&&(q={},i[z.id]=q);let G=L.isInstancedMesh===!0?L.id:0,ce=q[G];ce===void 0&&(ce={},q[G]=ce);let K=ce[W.id];K===void 0&&(K={},ce[W.id]=K);let Q=K[H];return Q===void 0&&(Q=f(l()),K[H]=Q),Q}function f(L){let z=[],W=[],I=[];for(let H=0;H<t;H++)z[H]=0,W[H]=0,I[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:I,object:L,attributes:{},index:null}}function p(L,z,W,I){let H=s.attributes,q=z.attributes,G=0,ce=W.getAttributes();for(let K in ce)if(ce[K].location>=0){let ee=H[K],de=q[K];if(de===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),ee===void 0||ee.attribute!==de||de&&ee.data!==de.data)return!0;G++}return s.attributesNum!==G||s.index!==I}function m(L,z,W,I){let H={},q=z.attributes,G=0,ce=W.getAttributes();for(let K in ce)if(ce[K].location>=0){let ee=q[K];ee===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor));let de={};de.attribute=ee,ee&&ee.data&&(de.data=ee.data),H[K]=de,G++}s.attributes=H,s.attributesNum=G,s.index=I}function M(){let L=s.newAttributes;for(let z=0,W=L.length;z<W;z++)L[z]=0}function d(L){g(L,0)}function g(L,z){let W=s.newAttributes,I=s.enabledAttributes,H=s.attributeDivisors;W[L]=1,I[L]===0&&(n.enableVertexAttribArray(L),I[L]=1),H[L]!==z&&(n.vertexAttribDivisor(L,z),H[L]=z)}function v(){let L=s.newAttributes,z=s.enabledAttributes;for(let W=0,I=z.length;W<I;W++)z[W]!==L[W]&&(n.disableVertexAttribArray(W),z[W]=0)}function T(L,z,W,I,H,q,G){G===!0?n.vertexAttribIPointer(L,z,W,H,q):n.vertexAttribPointer(L,z,W,I,H,q)}function y(L,z,W,I){M();let H=I.attributes,q=W.getAttributes(),G=z.defaultAttributeValues;for(let ce in q){let K=q[ce];if(K.location>=0){let Q=H[ce];if(Q===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ee=Q.normalized,de=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let j=ue.buffer,xe=ue.type,ve=ue.bytesPerElement,De=xe===n.INT||xe===n.UNSIGNED_INT||Q.gpuType===ho;if(Q.isInterleavedBufferAttribute){let we=Q.data,He=we.isInterleavedBuffer===!0?we.stride:we.itemSize,ot=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Je=0;Je<K.locationSize;Je++)g(K.location+Je,we.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Je=0;Je<K.locationSize;Je++)d(K.location+Je);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Je=0;Je<K.locationSize;Je++)T(K.location+Je,de/K.locationSize,xe,ee,He*ve,(ot+de/K.locationSize*Je)*ve,De)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<K.locationSize;we++)g(K.location+we,Q.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<K.locationSize;we++)d(K.location+we);n.bindBuffer(n.ARRAY_BUFFER,j);for(let we=0;we<K.locationSize;we++)T(K.location+we,de/K.locationSize,xe,ee,de*ve,de/K.locationSize*we*ve,De)}}else if(G!==void 0){let ee=G[ce];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(K.location,ee);break;case 3:n.vertexAttrib3fv(K.location,ee);break;case 4:n.vertexAttrib4fv(K.location,ee);break;default:n.vertexAttrib1fv(K.location,ee)}}}}v()}function C(){B();for(let L in i){let z=i[L];for(let W in z){let I=z[W];for(let H in I){let q=I[H];for(let G in q)u(q[G].object),delete q[G];delete I[H]}}delete i[L]}}function A(L){if(i[L.id]===void 0)return;let z=i[L.id];for(let W in z){let I=z[W];for(let H in I){let q=I[H];for(let G in q)u(q[G].object),delete q[G];delete I[H]}}delete i[L.id]}function x(L){for(let z in i){let W=i[z];for(let I in W){let H=W[I];if(H[L.id]===void 0)continue;let q=H[L.id];for(let G in q)u(q[G].object),delete q[G];delete H[L.id]}}}function w(L){for(let z in i){let W=i[z],I=L.isInstancedMesh===!0?L.id:0,H=W[I];if(H!==void 0){for(let q in H){let G=H[q];for(let ce in G)u(G[ce].object),delete G[ce];delete H[q]}delete W[I],Object.keys(W).length===0&&delete i[z]}}}function B(){D(),o=!0,s!==r&&(s=r,c(s.object))}function D(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:B,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:d,disableUnusedAttributes:v}}function Zx(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function Jx(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(x){return!(x!==Hi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let w=x===Di&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ui&&x!==bi&&!w&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Xe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Xe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Xe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:m,maxTextureSize:M,maxCubemapSize:d,maxAttributes:g,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:y,maxSamples:C,samples:A}}function Qx(n){let e=this,t=null,i=0,r=!1,s=!1,o=new yn,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||r;return r=f,i=h.length,p},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let m=h.clippingPlanes,M=h.clipIntersection,d=h.clipShadows,g=n.get(h);if(!r||m===null||m.length===0||s&&!d)s?u(null):c();else{let v=s?0:i,T=v*4,y=g.clippingState||null;l.value=y,y=u(m,f,T,p);for(let C=0;C!==T;++C)y[C]=t[C];g.clippingState=y,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,p,m){let M=h!==null?h.length:0,d=null;if(M!==0){if(d=l.value,m!==!0||d===null){let g=p+M*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<g)&&(d=new Float32Array(g));for(let T=0,y=p;T!==M;++T,y+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(d,y),d[y+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,d}}var as=class extends zi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Ho(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new ns(5,5,5),s=new hi({name:"CubemapFromEquirect",uniforms:Ir(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ei,blending:ur});s.uniforms.tEquirect.value=t;let o=new At(r,s),a=t.minFilter;return t.minFilter===mn&&(t.minFilter=xi),new Us(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var jx=256,nb=3,rb=20,n_=256,r_=16,sb=3,ob=new O,ab=new tt,El=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Us(1,10,null),this._boxMesh=new At(new ns(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=ob}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,M=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(e.background=l.getClearColor(ab));let d=new Us(i,r,u);return d.position.copy(a),d.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=m,e.background=M,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=i_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=t_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(jx,Nm(e))}_fromTexture(e,t){e.mapping===hr||e.mapping===$r?this._setSize(e.image.length===0?jx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=e_(e,!1,!1),i=Math.log2(e)-nb;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=e_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===hr||e.mapping===$r?(this._cubemapMaterial===null&&(this._cubemapMaterial=i_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=t_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=lb(),this._integrationMaterial=cb());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/r_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-sb)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(n_*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ub());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function e_(n,e,t){return new as(n,{minFilter:mn,generateMipmaps:e,type:Di,colorSpace:ws,depthBuffer:t})}function Tl(n,e,t){return new hi({name:n,uniforms:e,vertexShader:vt.cube_vert,fragmentShader:t,side:ei,blending:ur,depthTest:!1,depthWrite:!1})}function lb(){return Tl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${n_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function cb(){return Tl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:r_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ub(){return Tl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${rb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function t_(){return Tl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function i_(){return Tl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function s_(n){let e=new WeakMap,t=new WeakMap,i=null;function r(f,p=!1){return f==null?null:p?o(f):s(f)}function s(f){if(f&&f.isTexture){let p=f.mapping;if(p===Ac||p===Rc)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let M=new as(m.height);return M.fromEquirectangularTexture(n,f),e.set(f,M),f.addEventListener("dispose",c),a(M.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,m=p===Ac||p===Rc,M=p===hr||p===$r;if(m||M){let d=t.get(f),g=d!==void 0?d.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new El(n)),d=m?i.fromEquirectangular(f,d):i.fromCubemap(f,d),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),d.texture;if(d!==void 0)return d.texture;{let v=f.image;return m&&v&&v.height>0||M&&v&&l(v)?(i===null&&(i=new El(n)),d=m?i.fromEquirectangular(f):i.fromCubemap(f),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),f.addEventListener("dispose",u),d.texture):null}}}return f}function a(f,p){return p===Ac?f.mapping=hr:p===Rc&&(f.mapping=$r),f}function l(f){let p=0,m=6;for(let M=0;M<m;M++)f[M]!==void 0&&p++;return p===m}function c(f){let p=f.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:h}}function o_(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&Ts("WebGLRenderer: "+i+" extension not supported."),r}}}function a_(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let d in m.attributes)e.remove(m.attributes[d]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let M=s.get(m);M&&(e.remove(M),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,M){return r[M.id]!==void 0||(M.addEventListener("dispose",a),r[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function u(m){let M=m.attributes;for(let d in M)e.update(M[d],n.ARRAY_BUFFER)}function h(m){let M=m.index,d=m.attributes.position,g=0;if(d===void 0)return;let v=M!==null?M.array.length:d.array.length/3-1,T=d.count>=65535?Bo:Oo,y=new T(Math.ceil(v/3)*6,1),C=y.array;if(M!==null){let x=M.array;g=M.version;for(let w=0,B=0;w<v;w+=3){let D=x[w+0],L=x[w+1],z=x[w+2];C[B++]=D,C[B++]=L,C[B++]=L,C[B++]=z,C[B++]=z,C[B++]=D}}else{g=d.version;for(let x=0,w=0;x<v;x+=3){let B=x+0,D=x+1,L=x+2;C[w++]=B,C[w++]=D,C[w++]=D,C[w++]=L,C[w++]=L,C[w++]=B}}y.version=g;let A=s.get(m);A&&e.remove(A),s.set(m,y)}function f(m){let M=s.get(m);if(M){let d=m.index;d!==null&&M.version<d.version&&h(m)}else h(m);return s.get(m)}function p(){for(let m in r){let M=r[m].deref();M!==void 0&&l(M)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function l_(n,e,t){let i;function r(h){i=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,s,h*o),t.update(f,i,1)}function c(h,f,p){p!==0&&(n.drawElementsInstanced(i,f,s,h*o,p),t.update(f,i,p))}function u(h,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,h,0,p);let M=0;for(let d=0;d<p;d++)M+=f[d];t.update(M,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function c_(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:bt("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function u_(n,e,t){let i=new WeakMap,r=new It;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let B=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",B)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;p===!0&&(T=1),m===!0&&(T=2),M===!0&&(T=3);let y=a.attributes.position.count*T,C=1;y>e.maxTextureSize&&(C=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let A=new Float32Array(y*C*4*h),x=new To(A,y,C,h);x.type=bi,x.needsUpdate=!0;let w=T*4;for(let D=0;D<h;D++){let L=d[D],z=g[D],W=v[D],I=y*C*4*D;for(let H=0;H<L.count;H++){let q=H*w;p===!0&&(r.fromBufferAttribute(L,H),A[I+q+0]=r.x,A[I+q+1]=r.y,A[I+q+2]=r.z,A[I+q+3]=0),m===!0&&(r.fromBufferAttribute(z,H),A[I+q+4]=r.x,A[I+q+5]=r.y,A[I+q+6]=r.z,A[I+q+7]=0),M===!0&&(r.fromBufferAttribute(W,H),A[I+q+8]=r.x,A[I+q+9]=r.y,A[I+q+10]=r.z,A[I+q+11]=W.itemSize===4?r.w:1)}}f={count:h,texture:x,size:new le(y,C)},i.set(a,f),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let M=0;M<c.length;M++)p+=c[M];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:s}}function h_(n,e,t,i,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=e.get(c,h);if(s.get(f)!==u&&(e.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==u&&(p.update(),s.set(p,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hb={[yc]:"LINEAR_TONE_MAPPING",[Sc]:"REINHARD_TONE_MAPPING",[bc]:"CINEON_TONE_MAPPING",[wc]:"ACES_FILMIC_TONE_MAPPING",[Tc]:"AGX_TONE_MAPPING",[uo]:"NEUTRAL_TONE_MAPPING",[Ec]:"CUSTOM_TONE_MAPPING"};function f_(n,e,t,i,r,s){let o=new zi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Gt;u.setAttribute("position",new mt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new mt([0,2,0,0,2,0],2));let h=new wu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new At(u,h),p=new ea(-1,1,1,-1,0,1),m=null,M=null,d=!1,g,v=null,T=[],y=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let x=0;x<T.length;x++){let w=T[x];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){T=C,y=T.length>0&&T[0].isRenderPass===!0;let A=o.width,x=o.height;T.length>0&&a===null&&(a=new zi(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new zi(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&T.some(B=>B.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Sn(A,x),s===!0&&(c.format=gn,c.type=Xn)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let B=0;B<T.length;B++){let D=T[B];D.setSize&&D.setSize(A,x),w&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(C,A){if(d||C.toneMapping===dn&&T.length===0)return!1;if(v=A,A!==null){let x=A.width,w=A.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return y===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=dn,!0},this.hasRenderPass=function(){return y},this.end=function(C,A){C.toneMapping=g,d=!0;let x=o,w=a;for(let B=0;B<T.length;B++){let D=T[B];D.enabled!==!1&&(D.render(C,w,x,A),D.needsSwap!==!1&&(x=w,w=w===a?l:a))}if(m!==C.outputColorSpace||M!==C.toneMapping){m=C.outputColorSpace,M=C.toneMapping,h.defines={},_t.getTransfer(m)===Pt&&(h.defines.SRGB_TRANSFER="");let B=hb[M];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(f,p),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var v_=new ti,M_=new Sn(1,1),y_=new Vo(1),S_=new To,b_=new Xc,w_=new Ho,p_=[],d_=[],m_=new Float32Array(16),g_=new Float32Array(9),x_=new Float32Array(4);function na(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=p_[r];if(s===void 0&&(s=new Float32Array(r),p_[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Ei(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ti(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Fu(n,e){let t=d_[e];t===void 0&&(t=new Int32Array(e),d_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function fb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function pb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2fv(this.addr,e),Ti(t,e)}}function db(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ei(t,e))return;n.uniform3fv(this.addr,e),Ti(t,e)}}function mb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4fv(this.addr,e),Ti(t,e)}}function gb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;x_.set(i),n.uniformMatrix2fv(this.addr,!1,x_),Ti(t,i)}}function xb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;g_.set(i),n.uniformMatrix3fv(this.addr,!1,g_),Ti(t,i)}}function _b(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ei(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ti(t,e)}else{if(Ei(t,i))return;m_.set(i),n.uniformMatrix4fv(this.addr,!1,m_),Ti(t,i)}}function vb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Mb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2iv(this.addr,e),Ti(t,e)}}function yb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3iv(this.addr,e),Ti(t,e)}}function Sb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4iv(this.addr,e),Ti(t,e)}}function bb(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function wb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ei(t,e))return;n.uniform2uiv(this.addr,e),Ti(t,e)}}function Eb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ei(t,e))return;n.uniform3uiv(this.addr,e),Ti(t,e)}}function Tb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ei(t,e))return;n.uniform4uiv(this.addr,e),Ti(t,e)}}function Uu(n){return n.version===0&&(n.compareFunction=kc,n.needsUpdate=!0),n}function Ab(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Uu(M_):s=v_,t.setTexture2D(e||s,r)}function Rb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||b_,r)}function Cb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Uu(y_):s=w_,t.setTextureCube(e||s,r)}function Pb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||S_,r)}function Lb(n){switch(n){case 5126:return fb;case 35664:return pb;case 35665:return db;case 35666:return mb;case 35674:return gb;case 35675:return xb;case 35676:return _b;case 5124:case 35670:return vb;case 35667:case 35671:return Mb;case 35668:case 35672:return yb;case 35669:case 35673:return Sb;case 5125:return bb;case 36294:return wb;case 36295:return Eb;case 36296:return Tb;case 35678:case 36198:case 36298:case 36306:case 35682:return Ab;case 35679:case 36299:case 36307:return Rb;case 35680:case 36300:case 36308:case 36293:return Cb;case 36289:case 36303:case 36311:case 36292:return Pb}}function Db(n,e){n.uniform1fv(this.addr,e)}function Ib(n,e){let t=na(e,this.size,2);n.uniform2fv(this.addr,t)}function Fb(n,e){let t=na(e,this.size,3);n.uniform3fv(this.addr,t)}function Ub(n,e){let t=na(e,this.size,4);n.uniform4fv(this.addr,t)}function Nb(n,e){let t=na(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Ob(n,e){let t=na(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Bb(n,e){let t=na(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function kb(n,e){n.uniform1iv(this.addr,e)}function zb(n,e){n.uniform2iv(this.addr,e)}function Gb(n,e){n.uniform3iv(this.addr,e)}function Hb(n,e){n.uniform4iv(this.addr,e)}function Vb(n,e){n.uniform1uiv(this.addr,e)}function Wb(n,e){n.uniform2uiv(this.addr,e)}function Xb(n,e){n.uniform3uiv(this.addr,e)}function qb(n,e){n.uniform4uiv(this.addr,e)}function Yb(n,e,t){let i=this.cache,r=e.length,s=Fu(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Uu(M_):o=v_;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function $b(n,e,t){let i=this.cache,r=e.length,s=Fu(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||b_,s[o])}function Kb(n,e,t){let i=this.cache,r=e.length,s=Fu(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Uu(y_):o=w_;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function Zb(n,e,t){let i=this.cache,r=e.length,s=Fu(t,r);Ei(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||S_,s[o])}function Jb(n){switch(n){case 5126:return Db;case 35664:return Ib;case 35665:return Fb;case 35666:return Ub;case 35674:return Nb;case 35675:return Ob;case 35676:return Bb;case 5124:case 35670:return kb;case 35667:case 35671:return zb;case 35668:case 35672:return Gb;case 35669:case 35673:return Hb;case 5125:return Vb;case 36294:return Wb;case 36295:return Xb;case 36296:return qb;case 35678:case 36198:case 36298:case 36306:case 35682:return Yb;case 35679:case 36299:case 36307:return $b;case 35680:case 36300:case 36308:case 36293:return Kb;case 36289:case 36303:case 36311:case 36292:return Zb}}var Ef=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Lb(t.type)}},Tf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Jb(t.type)}},Af=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},wf=/(\w+)(\])?(\[|\.)?/g;function __(n,e){n.seq.push(e),n.map[e.id]=e}function Qb(n,e,t){let i=n.name,r=i.length;for(wf.lastIndex=0;;){let s=wf.exec(i),o=wf.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){__(t,c===void 0?new Ef(a,n,e):new Tf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Af(a),__(t,h)),t=h}}}var ls=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Qb(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Rf(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var jb=37297,ew=0;function tw(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var E_=new et;function iw(n){_t._getMatrix(E_,_t.workingColorSpace,n);let e=`mat3( ${E_.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case Es:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Xe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function T_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+tw(n.getShaderSource(e),a)}else return s}function nw(n,e){let t=iw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rw={[yc]:"Linear",[Sc]:"Reinhard",[bc]:"Cineon",[wc]:"ACESFilmic",[Tc]:"AgX",[uo]:"Neutral",[Ec]:"Custom"};function sw(n,e){let t=rw[e];return t===void 0?(Xe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Nu=new O;function ow(){_t.getLuminanceCoefficients(Nu);let n=Nu.x.toFixed(4),e=Nu.y.toFixed(4),t=Nu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function aw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Al).join(`
`)}function lw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function cw(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Al(n){return n!==""}function A_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function R_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var uw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Cf(n){return n.replace(uw,hw)}function hw(n,e){let t=vt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Cf(t)}var fw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function C_(n){return n.replace(fw,pw)}function pw(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function P_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var dw={[lo]:"SHADOWMAP_TYPE_PCF",[ys]:"SHADOWMAP_TYPE_VSM"};function mw(n){return dw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var gw={[$r]:"ENVMAP_MODE_REFRACTION"};function xw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":gw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var _w={[co]:"ENVMAP_BLENDING_MULTIPLY",[gm]:"ENVMAP_BLENDING_MIX",[xm]:"ENVMAP_BLENDING_ADD"};function vw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":_w[n.combine]||"ENVMAP_BLENDING_NONE"}function L_(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=mw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=xw(t),h=vw(t),f=aw(t),p=lw(s),m=r.createProgram(),M,d,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Al).join(`
`),M.length>0&&(M+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Al).join(`
`),d.length>0&&(d+=`
`)):(M=[P_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Al).join(`
`),d=[P_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==dn?"#define TONE_MAPPING":"",t.toneMapping!==dn?vt.tonemapping_pars_fragment:"",t.toneMapping!==dn?sw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",vt.colorspace_pars_fragment,nw("linearToOutputTexel",t.outputColorSpace),ow(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Al).join(`
`)),o=Cf(o),o=A_(o,t),o=R_(o,t),a=Cf(a),a=A_(a,t),a=R_(a,t),o=C_(o),a=C_(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,M=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,d=["#define varying in",t.glslVersion===Xh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Xh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=g+M+o,T=g+d+a,y=Rf(r,r.VERTEX_SHADER,v),C=Rf(r,r.FRAGMENT_SHADER,T);r.attachShader(m,y),r.attachShader(m,C),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function A(D){if(n.debug.checkShaderErrors){let L=r.getProgramInfoLog(m)||"",z=r.getShaderInfoLog(y)||"",W=r.getShaderInfoLog(C)||"",I=L.trim(),H=z.trim(),q=W.trim(),G=!0,ce=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,y,C);else{let K=T_(r,y,"vertex"),Q=T_(r,C,"fragment");bt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+I+`
`+K+`
`+Q)}else I!==""?Xe("WebGLProgram: Program Info Log:",I):(H===""||q==="")&&(ce=!1);ce&&(D.diagnostics={runnable:G,programLog:I,vertexShader:{log:H,prefix:M},fragmentShader:{log:q,prefix:d}})}r.deleteShader(y),r.deleteShader(C),x=new ls(r,m),w=cw(r,m)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=r.getProgramParameter(m,jb)),B},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=ew++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=y,this.fragmentShader=C,this}var Mw=0,Ou=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Pf(e),t.set(e,i)),i}},Pf=class{constructor(e){this.id=Mw++,this.code=e,this.usedTimes=0}};function yw(n){return n===xn||n===Ss||n===bs}function D_(n,e,t,i,r,s){let o=new Ro,a=new Ou,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,w,B,D,L,z){let W=D.fog,I=L.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||H,q),ce=f[x.type],K=i.precision;x.precision!==null&&(K=i.getMaxPrecision(x.precision),K!==x.precision&&Xe("WebGLProgram.getParameters:",x.precision,"not supported, using",K,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ee=Q!==void 0?Q.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let ue,j,xe,ve;if(ce){let Fe=On[ce];ue=Fe.vertexShader,j=Fe.fragmentShader}else{ue=x.vertexShader,j=x.fragmentShader;let Fe=a.getVertexShaderStage(x),Mt=a.getFragmentShaderStage(x);a.update(x,Fe,Mt),xe=Fe.id,ve=Mt.id}let De=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),He=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,Je=!!x.map,at=!!x.matcap,rt=!!G,se=rt&&G.isPMREMTexture===!0,Me=!!x.aoMap,_e=!!x.lightMap,Be=!!x.bumpMap&&x.wireframe===!1,Ie=!!x.normalMap,nt=!!x.displacementMap,ke=!!x.emissiveMap,gt=!!x.metalnessMap,pt=!!x.roughnessMap,yt=x.anisotropy>0,U=x.clearcoat>0,Se=x.diffuseRoughness>0,qe=x.dispersion>0,ht=x.retroreflectivity>0,Ee=x.iridescence>0,Nt=x.sheen>0,Ke=x.transmission>0,it=yt&&!!x.anisotropyMap,R=U&&!!x.clearcoatMap,S=U&&!!x.clearcoatNormalMap,X=U&&!!x.clearcoatRoughnessMap,pe=Se&&!!x.diffuseRoughnessMap,oe=Ee&&!!x.iridescenceMap,be=Ee&&!!x.iridescenceThicknessMap,Te=Nt&&!!x.sheenColorMap,te=Nt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,ge=!!x.specularColorMap,N=!!x.specularIntensityMap,re=Ke&&!!x.transmissionMap,ie=Ke&&!!x.thicknessMap,Ce=!!x.gradientMap,ye=!!x.alphaMap,Re=x.alphaTest>0,Qe=!!x.alphaHash,ct=!!x.extensions,fe=dn;x.toneMapped&&(De===null||De.isXRRenderTarget===!0)&&(fe=n.toneMapping);let Ye=se?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,ut={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:j,defines:x.defines,customVertexShaderID:xe,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:K,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:He,instancingColor:He&&L.instanceColor!==null,instancingMorph:He&&L.morphTexture!==null,outputColorSpace:De===null?n.outputColorSpace:De.isXRRenderTarget===!0?De.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Je,matcap:at,envMap:rt,envMapMode:rt&&G.mapping,envMapPMREM:se,envMapMaxLod:se?Ye.length-1:null,envMapSize:se?Ye[0].width:null,aoMap:Me,lightMap:_e,bumpMap:Be,normalMap:Ie,displacementMap:nt,emissiveMap:ke,normalMapObjectSpace:Ie&&x.normalMapType===Mm,normalMapTangentSpace:Ie&&x.normalMapType===ll,packedNormalMap:Ie&&x.normalMapType===ll&&yw(x.normalMap.format),metalnessMap:gt,roughnessMap:pt,anisotropy:yt,anisotropyMap:it,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Se,diffuseRoughnessMap:pe,dispersion:qe,retroreflection:ht,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:be,sheen:Nt,sheenColorMap:Te,sheenRoughnessMap:te,specularMap:ne,specularColorMap:ge,specularIntensityMap:N,transmission:Ke,transmissionMap:re,thicknessMap:ie,gradientMap:Ce,opaque:x.transparent===!1&&x.blending===Xr&&x.alphaToCoverage===!1,alphaMap:ye,alphaTest:Re,alphaHash:Qe,combine:x.combine,mapUv:Je&&p(x.map.channel),aoMapUv:Me&&p(x.aoMap.channel),lightMapUv:_e&&p(x.lightMap.channel),bumpMapUv:Be&&p(x.bumpMap.channel),normalMapUv:Ie&&p(x.normalMap.channel),displacementMapUv:nt&&p(x.displacementMap.channel),emissiveMapUv:ke&&p(x.emissiveMap.channel),metalnessMapUv:gt&&p(x.metalnessMap.channel),roughnessMapUv:pt&&p(x.roughnessMap.channel),anisotropyMapUv:it&&p(x.anisotropyMap.channel),clearcoatMapUv:R&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:be&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:Te&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(x.sheenRoughnessMap.channel),specularMapUv:ne&&p(x.specularMap.channel),specularColorMapUv:ge&&p(x.specularColorMap.channel),specularIntensityMapUv:N&&p(x.specularIntensityMap.channel),transmissionMapUv:re&&p(x.transmissionMap.channel),thicknessMapUv:ie&&p(x.thicknessMap.channel),alphaMapUv:ye&&p(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ie||yt),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Je||ye),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Ie===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:we,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(Fe=>Fe.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:Je&&x.map.isVideoTexture===!0&&_t.getTransfer(x.map.colorSpace)===Pt,decodeVideoTextureEmissive:ke&&x.emissiveMap.isVideoTexture===!0&&_t.getTransfer(x.emissiveMap.colorSpace)===Pt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Si,flipSided:x.side===ei,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ct&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ct&&x.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ut.vertexUv1s=l.has(1),ut.vertexUv2s=l.has(2),ut.vertexUv3s=l.has(3),l.clear(),ut}function M(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)w.push(B),w.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(d(w,x),g(w,x),w.push(n.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function d(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function g(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let w=f[x.type],B;if(w){let D=On[w];B=dg.clone(D.uniforms)}else B=x.uniforms;return B}function T(x,w){let B=u.get(w);return B!==void 0?++B.usedTimes:(B=new L_(n,w,x,r),c.push(B),u.set(w,B)),B}function y(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:M,getUniforms:v,acquireProgram:T,releaseProgram:y,releaseShaderCache:C,programs:c,dispose:A}}function I_(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function Sw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function F_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function U_(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,m,M,d,g){let v=n[e];return v===void 0?(v={id:f.id,object:f,geometry:p,material:m,materialVariant:o(f),groupOrder:M,renderOrder:f.renderOrder,z:d,group:g},n[e]=v):(v.id=f.id,v.object=f,v.geometry=p,v.material=m,v.materialVariant=o(f),v.groupOrder=M,v.renderOrder=f.renderOrder,v.z=d,v.group=g),e++,v}function l(f,p,m,M,d,g,v){v.reversedDepth===!0&&(d=-d);let T=a(f,p,m,M,d,g);m.transmission>0?i.push(T):m.transparent===!0?r.push(T):t.push(T)}function c(f,p,m,M,d,g){let v=a(f,p,m,M,d,g);m.transmission>0?i.unshift(v):m.transparent===!0?r.unshift(v):t.unshift(v)}function u(f,p){t.length>1&&t.sort(f||Sw),i.length>1&&i.sort(p||F_),r.length>1&&r.sort(p||F_)}function h(){for(let f=e,p=n.length;f<p;f++){let m=n[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function N_(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new U_,n.set(i,[o])):r>=s.length?(o=new U_,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function bw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new O,color:new tt};break;case"SpotLight":t={position:new O,direction:new O,color:new tt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new O,color:new tt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new O,skyColor:new tt,groundColor:new tt};break;case"RectAreaLight":t={color:new tt,position:new O,halfWidth:new O,halfHeight:new O};break}return n[e.id]=t,t}}}function ww(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var Ew=0;function Tw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function O_(n){let e=new bw,t=ww(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new O);let r=new O,s=new st,o=new st;function a(c){let u=0,h=0,f=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let p=0,m=0,M=0,d=0,g=0,v=0,T=0,y=0,C=0,A=0,x=0,w=0,B=0,D=0;c.sort(Tw);for(let z=0,W=c.length;z<W;z++){let I=c[z],H=I.color,q=I.intensity,G=I.distance,ce=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===xn?ce=I.shadow.map.texture:ce=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=H.r*q,h+=H.g*q,f+=H.b*q;else if(I.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(I.sh.coefficients[K],q);D++}else if(I.isSunLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=ee,i.sunShadowMap[m]=ce;let de=Q.getViewportCount();for(let ue=0;ue<de;ue++)i.sunShadowMatrix[M+ue]=Q.getMatrix(ue),i.sunShadowCascade[M+ue]=Q._cascadeData[ue];M+=de,m++}i.sun[p]=K,p++}else if(I.isDirectionalLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,i.directionalShadow[d]=ee,i.directionalShadowMap[d]=ce,i.directionalShadowMatrix[d]=I.shadow.matrix,C++}i.directional[d]=K,d++}else if(I.isSpotLight){let K=e.get(I);K.position.setFromMatrixPosition(I.matrixWorld),K.color.copy(H).multiplyScalar(q),K.distance=G,K.coneCos=Math.cos(I.angle),K.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),K.decay=I.decay,i.spot[v]=K;let Q=I.shadow;if(I.map&&(i.spotLightMap[w]=I.map,w++,Q.updateMatrices(I),I.castShadow&&B++),i.spotLightMatrix[v]=Q.matrix,I.castShadow){let ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,i.spotShadow[v]=ee,i.spotShadowMap[v]=ce,x++}v++}else if(I.isRectAreaLight){let K=e.get(I);K.color.copy(H).multiplyScalar(q),K.halfWidth.set(I.width*.5,0,0),K.halfHeight.set(0,I.height*.5,0),i.rectArea[T]=K,T++}else if(I.isPointLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),K.distance=I.distance,K.decay=I.decay,I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,ee.shadowCameraNear=Q.camera.near,ee.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ee,i.pointShadowMap[g]=ce,i.pointShadowMatrix[g]=I.shadow.matrix,A++}i.point[g]=K,g++}else if(I.isHemisphereLight){let K=e.get(I);K.skyColor.copy(I.color).multiplyScalar(q),K.groundColor.copy(I.groundColor).multiplyScalar(q),i.hemi[y]=K,y++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let L=i.hash;(L.sunLength!==p||L.directionalLength!==d||L.pointLength!==g||L.spotLength!==v||L.rectAreaLength!==T||L.hemiLength!==y||L.numSunShadows!==m||L.numDirectionalShadows!==C||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==w||L.numLightProbes!==D)&&(i.sun.length=p,i.directional.length=d,i.spot.length=v,i.rectArea.length=T,i.point.length=g,i.hemi.length=y,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+w-B,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=D,L.sunLength=p,L.directionalLength=d,L.pointLength=g,L.spotLength=v,L.rectAreaLength=T,L.hemiLength=y,L.numSunShadows=m,L.numDirectionalShadows=C,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=w,L.numLightProbes=D,i.version=Ew++)}function l(c,u){let h=0,f=0,p=0,m=0,M=0,d=0,g=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let y=c[v];if(y.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(g),h++}else if(y.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(y.matrixWorld),r.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(g),f++}else if(y.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(y.matrixWorld),r.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(g),m++}else if(y.isRectAreaLight){let C=i.rectArea[M];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),o.identity(),s.copy(y.matrixWorld),s.premultiply(g),o.extractRotation(s),C.halfWidth.set(y.width*.5,0,0),C.halfHeight.set(0,y.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),M++}else if(y.isPointLight){let C=i.point[p];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),p++}else if(y.isHemisphereLight){let C=i.hemi[d];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(g),d++}}}return{setup:a,setupView:l,state:i}}function B_(n){let e=new O_(n),t=[],i=[],r=[];function s(h){u.camera=h,t.length=0,i.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function k_(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new B_(n),e.set(r,[a])):s>=o.length?(a=new B_(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var z_=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,G_=`
uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
const float samples = float( VSM_SAMPLES );
float mean = 0.0;
float squared_mean = 0.0;
float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
for ( float i = 0.0; i < samples; i ++ ) {
float uvOffset = uvStart + i * uvStride;
#ifdef HORIZONTAL_PASS
vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
mean += distribution.x;
squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
#else
float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
mean += depth;
squared_mean += depth * depth;
#endif
}
mean = mean / samples;
squared_mean = squared_mean / samples;
float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}
`;var Rw=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],Cw=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],H_=new st,Rl=new O,Lf=new O;function V_(n,e,t){let i=new Qn,r=new le,s=new le,o=new It,a=new Eu,l=new Tu,c={},u=t.maxTextureSize,h={[Rn]:ei,[ei]:Rn,[Si]:Si},f=new hi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new le},radius:{value:4}},vertexShader:z_,fragmentShader:G_}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new Gt;m.setAttribute("position",new vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new At(m,f),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=lo;let g=this.type;this.render=function(A,x,w){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Jd&&(Xe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=lo);let B=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),z=n.state;z.setBlending(ur),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=g!==this.type;W&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(H=>H.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,H=A.length;I<H;I++){let q=A[I],G=q.shadow;if(G===void 0){Xe("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;r.copy(G.mapSize);let ce=G.getFrameExtents();r.multiply(ce),s.copy(G.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/ce.x),r.x=s.x*ce.x,G.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/ce.y),r.y=s.y*ce.y,G.mapSize.y=s.y));let K=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=K,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===ys){if(q.isPointLight){Xe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new zi(r.x,r.y,{format:xn,type:Di,minFilter:xi,magFilter:xi,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Sn(r.x,r.y,bi),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=nn,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Jt,G.map.depthTexture.magFilter=Jt}else q.isPointLight?(G.map=new as(r.x),G.map.depthTexture=new Vo(r.x,Li)):(G.map=new zi(r.x,r.y),G.map.depthTexture=new Sn(r.x,r.y,Li)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=nn,this.type===lo?(G.map.depthTexture.compareFunction=K?Bc:Oc,G.map.depthTexture.minFilter=xi,G.map.depthTexture.magFilter=xi):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Jt,G.map.depthTexture.magFilter=Jt);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==r.x||G.map.height!==r.y)&&G.map.setSize(r.x,r.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,w);let ee=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let de=0;de<Q;de++){let ue=G.getCamera(de);if(q.isPointLight){let j=G.camera,xe=G.matrix,ve=q.distance||j.far;ve!==j.far&&(j.far=ve,j.updateProjectionMatrix()),Rl.setFromMatrixPosition(q.matrixWorld),j.position.copy(Rl),Lf.copy(j.position),Lf.add(Rw[de]),j.up.copy(Cw[de]),j.lookAt(Lf),j.updateMatrixWorld(),xe.makeTranslation(-Rl.x,-Rl.y,-Rl.z),H_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),G._frustum.setFromProjectionMatrix(H_,j.coordinateSystem,j.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,de),n.clear();else{de===0&&(n.setRenderTarget(G.map),n.clear());let j=G.getViewport(de);o.set(s.x*j.x,s.y*j.y,s.x*j.z,s.y*j.w),z.viewport(o)}i=G.getFrustum(de),y(x,w,ue,q,ee,this.type)}G.isPointLightShadow!==!0&&this.type===ys&&v(G,w),G.needsUpdate=!1}g=this.type,d.needsUpdate=!1,n.setRenderTarget(B,D,L)};function v(A,x){let w=e.update(M);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new zi(r.x,r.y,{format:xn,type:Di}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,w,f,M,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,w,p,M,null)}function T(A,x,w,B){let D=null,L=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)D=L;else if(D=w.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=D.uuid,W=x.uuid,I=c[z];I===void 0&&(I={},c[z]=I);let H=I[W];H===void 0&&(H=D.clone(),I[W]=H,x.addEventListener("dispose",C)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,B===ys?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:h[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,w.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let z=n.properties.get(D);z.light=w}return D}function y(A,x,w,B,D,L){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===ys)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let I=e.update(A),H=A.material;if(Array.isArray(H)){let q=I.groups;for(let G=0,ce=q.length;G<ce;G++){let K=q[G],Q=H[K.materialIndex];if(Q&&Q.visible){let ee=T(A,Q,B,L);A.onBeforeShadow(n,A,x,w,I,ee,K),n.renderBufferDirect(w,null,I,ee,A,K),A.onAfterShadow(n,A,x,w,I,ee,K)}}}else if(H.visible){let q=T(A,H,B,L);A.onBeforeShadow(n,A,x,w,I,q,null),n.renderBufferDirect(w,null,I,q,A,null),A.onAfterShadow(n,A,x,w,I,q,null)}}let W=A.children;for(let I=0,H=W.length;I<H;I++)y(W[I],x,w,B,D,L)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let B=c[w],D=A.target.uuid;D in B&&(B[D].dispose(),delete B[D])}}}function W_(n,e){function t(){let N=!1,re=new It,ie=null,Ce=new It(0,0,0,0);return{setMask:function(ye){ie!==ye&&!N&&(n.colorMask(ye,ye,ye,ye),ie=ye)},setLocked:function(ye){N=ye},setClear:function(ye,Re,Qe,ct,fe){fe===!0&&(ye*=ct,Re*=ct,Qe*=ct),re.set(ye,Re,Qe,ct),Ce.equals(re)===!1&&(n.clearColor(ye,Re,Qe,ct),Ce.copy(re))},reset:function(){N=!1,ie=null,Ce.set(-1,0,0,0)}}}function i(){let N=!1,re=!1,ie=null,Ce=null,ye=null;return{setReversed:function(Re){if(re!==Re){let Qe=e.get("EXT_clip_control");Re?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT),re=Re;let ct=ye;ye=null,this.setClear(ct)}},getReversed:function(){return re},setTest:function(Re){Re?we(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Re){ie!==Re&&!N&&(n.depthMask(Re),ie=Re)},setFunc:function(Re){if(re&&(Re=Fm[Re]),Ce!==Re){switch(Re){case ba:n.depthFunc(n.NEVER);break;case wa:n.depthFunc(n.ALWAYS);break;case Ea:n.depthFunc(n.LESS);break;case Yr:n.depthFunc(n.LEQUAL);break;case Ta:n.depthFunc(n.EQUAL);break;case Aa:n.depthFunc(n.GEQUAL);break;case Ra:n.depthFunc(n.GREATER);break;case Ca:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ce=Re}},setLocked:function(Re){N=Re},setClear:function(Re){ye!==Re&&(ye=Re,re&&(Re=1-Re),n.clearDepth(Re))},reset:function(){N=!1,ie=null,Ce=null,ye=null,re=!1}}}function r(){let N=!1,re=null,ie=null,Ce=null,ye=null,Re=null,Qe=null,ct=null,fe=null;return{setTest:function(Ye){N||(Ye?we(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Ye){re!==Ye&&!N&&(n.stencilMask(Ye),re=Ye)},setFunc:function(Ye,ut,Fe){(ie!==Ye||Ce!==ut||ye!==Fe)&&(n.stencilFunc(Ye,ut,Fe),ie=Ye,Ce=ut,ye=Fe)},setOp:function(Ye,ut,Fe){(Re!==Ye||Qe!==ut||ct!==Fe)&&(n.stencilOp(Ye,ut,Fe),Re=Ye,Qe=ut,ct=Fe)},setLocked:function(Ye){N=Ye},setClear:function(Ye){fe!==Ye&&(n.clearStencil(Ye),fe=Ye)},reset:function(){N=!1,re=null,ie=null,Ce=null,ye=null,Re=null,Qe=null,ct=null,fe=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,u={},h={},f={},p=new WeakMap,m=[],M=null,d=!1,g=null,v=null,T=null,y=null,C=null,A=null,x=null,w=new tt(0,0,0),B=0,D=!1,L=null,z=null,W=null,I=null,H=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(K)[1]),G=ce>=1):K.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),G=ce>=2);let Q=null,ee={},de=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),j=new It().fromArray(de),xe=new It().fromArray(ue);function ve(N,re,ie,Ce){let ye=new Uint8Array(4),Re=n.createTexture();n.bindTexture(N,Re),n.texParameteri(N,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(N,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Qe=0;Qe<ie;Qe++)N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ce,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(re+Qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return Re}let De={};De[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),De[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),De[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),De[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(Yr),Be(!1),Ie(zh),we(n.CULL_FACE),Me(ur);function we(N){u[N]!==!0&&(n.enable(N),u[N]=!0)}function He(N){u[N]!==!1&&(n.disable(N),u[N]=!1)}function ot(N,re){return f[N]!==re?(n.bindFramebuffer(N,re),f[N]=re,N===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=re),N===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Je(N,re){let ie=m,Ce=!1;if(N){ie=p.get(re),ie===void 0&&(ie=[],p.set(re,ie));let ye=N.textures;if(ie.length!==ye.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Re=0,Qe=ye.length;Re<Qe;Re++)ie[Re]=n.COLOR_ATTACHMENT0+Re;ie.length=ye.length,Ce=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ce=!0);Ce&&n.drawBuffers(ie)}function at(N){return M!==N?(n.useProgram(N),M=N,!0):!1}let rt={[qr]:n.FUNC_ADD,[jd]:n.FUNC_SUBTRACT,[em]:n.FUNC_REVERSE_SUBTRACT};rt[tm]=n.MIN,rt[im]=n.MAX;let se={[nm]:n.ZERO,[rm]:n.ONE,[sm]:n.SRC_COLOR,[vc]:n.SRC_ALPHA,[hm]:n.SRC_ALPHA_SATURATE,[cm]:n.DST_COLOR,[am]:n.DST_ALPHA,[om]:n.ONE_MINUS_SRC_COLOR,[Mc]:n.ONE_MINUS_SRC_ALPHA,[um]:n.ONE_MINUS_DST_COLOR,[lm]:n.ONE_MINUS_DST_ALPHA,[fm]:n.CONSTANT_COLOR,[pm]:n.ONE_MINUS_CONSTANT_COLOR,[dm]:n.CONSTANT_ALPHA,[mm]:n.ONE_MINUS_CONSTANT_ALPHA};function Me(N,re,ie,Ce,ye,Re,Qe,ct,fe,Ye){if(N===ur){d===!0&&(He(n.BLEND),d=!1);return}if(d===!1&&(we(n.BLEND),d=!0),N!==Qd){if(N!==g||Ye!==D){if((v!==qr||C!==qr)&&(n.blendEquation(n.FUNC_ADD),v=qr,C=qr),Ye)switch(N){case Xr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gh:n.blendFunc(n.ONE,n.ONE);break;case Hh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Vh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:bt("WebGLState: Invalid blending: ",N);break}else switch(N){case Xr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hh:bt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vh:bt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:bt("WebGLState: Invalid blending: ",N);break}T=null,y=null,A=null,x=null,w.set(0,0,0),B=0,g=N,D=Ye}return}ye=ye||re,Re=Re||ie,Qe=Qe||Ce,(re!==v||ye!==C)&&(n.blendEquationSeparate(rt[re],rt[ye]),v=re,C=ye),(ie!==T||Ce!==y||Re!==A||Qe!==x)&&(n.blendFuncSeparate(se[ie],se[Ce],se[Re],se[Qe]),T=ie,y=Ce,A=Re,x=Qe),(ct.equals(w)===!1||fe!==B)&&(n.blendColor(ct.r,ct.g,ct.b,fe),w.copy(ct),B=fe),g=N,D=!1}function _e(N,re){N.side===Si?He(n.CULL_FACE):we(n.CULL_FACE);let ie=N.side===ei;re&&(ie=!ie),Be(ie),N.blending===Xr&&N.transparent===!1?Me(ur):Me(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),s.setMask(N.colorWrite);let Ce=N.stencilWrite;a.setTest(Ce),Ce&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),ke(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function Be(N){L!==N&&(N?n.frontFace(n.CW):n.frontFace(n.CCW),L=N)}function Ie(N){N!==Kd?(we(n.CULL_FACE),N!==z&&(N===zh?n.cullFace(n.BACK):N===Zd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),z=N}function nt(N){N!==W&&(G&&n.lineWidth(N),W=N)}function ke(N,re,ie){N?(we(n.POLYGON_OFFSET_FILL),(I!==re||H!==ie)&&(I=re,H=ie,o.getReversed()&&(re=-re,ie=-ie),n.polygonOffset(re,ie))):He(n.POLYGON_OFFSET_FILL)}function gt(N){N?we(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function pt(N){N===void 0&&(N=n.TEXTURE0+q-1),Q!==N&&(n.activeTexture(N),Q=N)}function yt(N,re,ie){ie===void 0&&(Q===null?ie=n.TEXTURE0+q-1:ie=Q);let Ce=ee[ie];Ce===void 0&&(Ce={type:void 0,texture:void 0},ee[ie]=Ce),(Ce.type!==N||Ce.texture!==re)&&(Q!==ie&&(n.activeTexture(ie),Q=ie),n.bindTexture(N,re||De[N]),Ce.type=N,Ce.texture=re)}function U(){let N=ee[Q];N!==void 0&&N.type!==void 0&&(n.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Se(){try{n.compressedTexImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function ht(){try{n.texSubImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function Nt(){try{n.compressedTexSubImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function Ke(){try{n.compressedTexSubImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function it(){try{n.texStorage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function R(){try{n.texStorage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function S(){try{n.texImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function X(){try{n.texImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function pe(N){return h[N]!==void 0?h[N]:n.getParameter(N)}function oe(N,re){h[N]!==re&&(n.pixelStorei(N,re),h[N]=re)}function be(N){j.equals(N)===!1&&(n.scissor(N.x,N.y,N.z,N.w),j.copy(N))}function Te(N){xe.equals(N)===!1&&(n.viewport(N.x,N.y,N.z,N.w),xe.copy(N))}function te(N,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Ce=ie.get(N);Ce===void 0&&(Ce=n.getUniformBlockIndex(re,N.name),n.uniformBlockBinding(re,Ce,Ce),ie.set(N,Ce))}function ne(N,re,ie){let ye=c.get(re).get(N);l[ye]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,ie),l[ye]=ie)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ee={},f={},l={},p=new WeakMap,m=[],M=null,d=!1,g=null,v=null,T=null,y=null,C=null,A=null,x=null,w=new tt(0,0,0),B=0,D=!1,L=null,z=null,W=null,I=null,H=null,j.set(0,0,n.canvas.width,n.canvas.height),xe.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:we,disable:He,bindFramebuffer:ot,drawBuffers:Je,useProgram:at,setBlending:Me,setMaterial:_e,setFlipSided:Be,setCullFace:Ie,setLineWidth:nt,setPolygonOffset:ke,setScissorTest:gt,activeTexture:pt,bindTexture:yt,unbindTexture:U,compressedTexImage2D:Se,compressedTexImage3D:qe,texImage2D:S,texImage3D:X,pixelStorei:oe,getParameter:pe,updateUBOMapping:te,uniformBlockBinding:ne,texStorage2D:it,texStorage3D:R,texSubImage2D:ht,texSubImage3D:Ee,compressedTexSubImage2D:Nt,compressedTexSubImage3D:Ke,scissor:be,viewport:Te,reset:ge}}function X_(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new le,u=new WeakMap,h=new Set,f,p=new WeakMap,m=new Set,M=new FinalizationRegistry(R=>m.delete(R)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return d?new OffscreenCanvas(R,S):wo("canvas")}function v(R,S,X){let pe=1,oe=it(R);if((oe.width>X||oe.height>X)&&(pe=X/Math.max(oe.width,oe.height)),pe<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let be=Math.floor(pe*oe.width),Te=Math.floor(pe*oe.height);f===void 0&&(f=g(be,Te));let te=S?g(be,Te):f;return te.width=be,te.height=Te,te.getContext("2d").drawImage(R,0,0,be,Te),Xe("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+be+"x"+Te+")."),te}else return"data"in R&&Xe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function T(R){return R.generateMipmaps}function y(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,S,X,pe,oe,be=!1){if(R!==null){if(n[R]!==void 0)return n[R];Xe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Te;pe&&(Te=e.get("EXT_texture_norm16"),Te||Xe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.R16_EXT),X===n.SHORT&&Te&&(te=Te.R16_SNORM_EXT)),S===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),S===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.RG16_EXT),X===n.SHORT&&Te&&(te=Te.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),S===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),S===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),S===n.RGB&&(X===n.UNSIGNED_SHORT&&Te&&(te=Te.RGB16_EXT),X===n.SHORT&&Te&&(te=Te.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),S===n.RGBA){let ne=be?Es:_t.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===Pt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.RGBA16_EXT),X===n.SHORT&&Te&&(te=Te.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,S){let X;return R?S===null||S===Li||S===Xn?X=n.DEPTH24_STENCIL8:S===bi?X=n.DEPTH32F_STENCIL8:S===Er&&(X=n.DEPTH24_STENCIL8,Xe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Li||S===Xn?X=n.DEPTH_COMPONENT24:S===bi?X=n.DEPTH_COMPONENT32F:S===Er&&(X=n.DEPTH_COMPONENT16),X}function w(R,S){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==Jt&&R.minFilter!==xi?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function B(R){let S=new WeakRef(R);i.get(R).__ref=S,m.add(S),M.register(R,S,S)}function D(R){let S=i.get(R).__ref;S!==void 0&&(m.delete(S),M.unregister(S))}function L(R){W(R.target)}function z(R){I(R.target)}function W(R){R.removeEventListener("dispose",L),D(R),q(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function I(R){R.removeEventListener("dispose",z),D(R),ce(R)}function H(){for(let R of m){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):W(S))}m.clear(),h.clear()}function q(R){let S=i.get(R);if(S.__webglInit===void 0)return;let X=R.source,pe=p.get(X);if(pe){let oe=pe[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(pe).length===0&&p.delete(X)}i.remove(R)}function G(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let X=R.source,pe=p.get(X);delete pe[S.__cacheKey],o.memory.textures--}function ce(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&W(X),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let be=0;be<S.__webglFramebuffer[oe].length;be++)n.deleteFramebuffer(S.__webglFramebuffer[oe][be]);else n.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)n.deleteFramebuffer(S.__webglFramebuffer[oe]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let pe=R.textures;for(let oe=0,be=pe.length;oe<be;oe++){let Te=i.get(pe[oe]);Te.__webglTexture&&(n.deleteTexture(Te.__webglTexture),o.memory.textures--),i.remove(pe[oe])}i.remove(R)}let K=0;function Q(){K=0}function ee(){return K}function de(R){K=R}function ue(){let R=K;return R>=r.maxTextures&&Xe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),K+=1,R}function j(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function xe(R,S){let X=i.get(R);if(R.isVideoTexture&&Nt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let pe=R.image;if(pe===null)Xe("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)Xe("WebGLRenderer: Texture marked for update but image is incomplete");else{_e(X,R,S);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+S)}function ve(R,S){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){_e(X,R,S);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+S)}function De(R,S){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){_e(X,R,S);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+S)}function we(R,S){let X=i.get(R);if(R.version>0&&X.__version!==R.version){Be(X,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+S)}let He={[Kr]:n.REPEAT,[tn]:n.CLAMP_TO_EDGE,[Pa]:n.MIRRORED_REPEAT},ot={[Jt]:n.NEAREST,[_m]:n.NEAREST_MIPMAP_NEAREST,[La]:n.NEAREST_MIPMAP_LINEAR,[xi]:n.LINEAR,[Cc]:n.LINEAR_MIPMAP_NEAREST,[mn]:n.LINEAR_MIPMAP_LINEAR},Je={[Sm]:n.NEVER,[kc]:n.ALWAYS,[bm]:n.LESS,[Oc]:n.LEQUAL,[wm]:n.EQUAL,[Bc]:n.GEQUAL,[Em]:n.GREATER,[Tm]:n.NOTEQUAL};function at(R,S){if(S.type===bi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===xi||S.magFilter===Cc||S.magFilter===La||S.magFilter===mn||S.minFilter===xi||S.minFilter===Cc||S.minFilter===La||S.minFilter===mn)&&Xe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,He[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,He[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,He[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Je[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Jt||S.minFilter!==La&&S.minFilter!==mn||S.type===bi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,r.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function rt(R,S){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",L),B(S));let pe=S.source,oe=p.get(pe);oe===void 0&&(oe={},p.set(pe,oe));let be=j(S);if(be!==R.__cacheKey){oe[be]===void 0&&(oe[be]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[be].usedTimes++;let Te=oe[R.__cacheKey];Te!==void 0&&(oe[R.__cacheKey].usedTimes--,Te.usedTimes===0&&G(S)),R.__cacheKey=be,R.__webglTexture=oe[be].texture}return X}function se(R,S,X){return Math.floor(Math.floor(R/X)/S)}function Me(R,S,X,pe){let be=R.updateRanges;if(be.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,X,pe,S.data);else{be.sort((N,re)=>N.start-re.start);let Te=0;for(let N=1;N<be.length;N++){let re=be[Te],ie=be[N],Ce=re.start+re.count,ye=se(ie.start,S.width,4),Re=se(re.start,S.width,4);ie.start<=Ce+1&&ye===Re&&se(ie.start+ie.count-1,S.width,4)===ye?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++Te,be[Te]=ie)}be.length=Te+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let N=0,re=be.length;N<re;N++){let ie=be[N],Ce=Math.floor(ie.start/4),ye=Math.ceil(ie.count/4),Re=Ce%S.width,Qe=Math.floor(Ce/S.width),ct=ye,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Re),t.pixelStorei(n.UNPACK_SKIP_ROWS,Qe),t.texSubImage2D(n.TEXTURE_2D,0,Re,Qe,ct,fe,X,pe,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function _e(R,S,X){let pe=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(pe=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(pe=n.TEXTURE_3D);let oe=rt(R,S),be=S.source;t.bindTexture(pe,R.__webglTexture,n.TEXTURE0+X);let Te=i.get(be);if(be.version!==Te.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let fe=_t.getPrimaries(_t.workingColorSpace),Ye=S.colorSpace===Cn?null:_t.getPrimaries(S.colorSpace),ut=S.colorSpace===Cn||fe===Ye?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ut)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let ne=v(S.image,!1,r.maxTextureSize);ne=Ke(S,ne);let ge=s.convert(S.format,S.colorSpace),N=s.convert(S.type),re=A(S.internalFormat,ge,N,S.normalized,S.colorSpace,S.isVideoTexture);at(pe,S);let ie,Ce=S.mipmaps,ye=S.isVideoTexture!==!0,Re=Te.__version===void 0||oe===!0,Qe=be.dataReady,ct=w(S,ne);if(S.isDepthTexture)re=x(S.format===gn,S.type),Re&&(ye?t.texStorage2D(n.TEXTURE_2D,1,re,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,re,ne.width,ne.height,0,ge,N,null));else if(S.isDataTexture)if(Ce.length>0){ye&&Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,Ce[0].width,Ce[0].height);for(let fe=0,Ye=Ce.length;fe<Ye;fe++)ie=Ce[fe],ye?Qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,ie.width,ie.height,ge,N,ie.data):t.texImage2D(n.TEXTURE_2D,fe,re,ie.width,ie.height,0,ge,N,ie.data);S.generateMipmaps=!1}else ye?(Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,ne.width,ne.height),Qe&&Me(S,ne,ge,N)):t.texImage2D(n.TEXTURE_2D,0,re,ne.width,ne.height,0,ge,N,ne.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){ye&&Re&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ct,re,Ce[0].width,Ce[0].height,ne.depth);for(let fe=0,Ye=Ce.length;fe<Ye;fe++)if(ie=Ce[fe],S.format!==Hi)if(ge!==null)if(ye){if(Qe)if(S.layerUpdates.size>0){let ut=Sf(ie.width,ie.height,S.format,S.type);for(let Fe of S.layerUpdates){let Mt=ie.data.subarray(Fe*ut/ie.data.BYTES_PER_ELEMENT,(Fe+1)*ut/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Fe,ie.width,ie.height,1,ge,Mt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,ie.width,ie.height,ne.depth,ge,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,re,ie.width,ie.height,ne.depth,0,ie.data,0,0);else Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,ie.width,ie.height,ne.depth,ge,N,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,re,ie.width,ie.height,ne.depth,0,ge,N,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{ye&&Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,Ce[0].width,Ce[0].height);for(let fe=0,Ye=Ce.length;fe<Ye;fe++)ie=Ce[fe],S.format!==Hi?ge!==null?ye?Qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,re,ie.width,ie.height,0,ie.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,ie.width,ie.height,ge,N,ie.data):t.texImage2D(n.TEXTURE_2D,fe,re,ie.width,ie.height,0,ge,N,ie.data)}else if(S.isDataArrayTexture)if(ye){if(Re&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ct,re,ne.width,ne.height,ne.depth),Qe)if(S.layerUpdates.size>0){let fe=Sf(ne.width,ne.height,S.format,S.type);for(let Ye of S.layerUpdates){let ut=ne.data.subarray(Ye*fe/ne.data.BYTES_PER_ELEMENT,(Ye+1)*fe/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ye,ne.width,ne.height,1,ge,N,ut)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,ge,N,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ne.width,ne.height,ne.depth,0,ge,N,ne.data);else if(S.isData3DTexture)ye?(Re&&t.texStorage3D(n.TEXTURE_3D,ct,re,ne.width,ne.height,ne.depth),Qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,ge,N,ne.data)):t.texImage3D(n.TEXTURE_3D,0,re,ne.width,ne.height,ne.depth,0,ge,N,ne.data);else if(S.isFramebufferTexture){if(Re)if(ye)t.texStorage2D(n.TEXTURE_2D,ct,re,ne.width,ne.height);else{let fe=ne.width,Ye=ne.height;for(let ut=0;ut<ct;ut++)t.texImage2D(n.TEXTURE_2D,ut,re,fe,Ye,0,ge,N,null),fe>>=1,Ye>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),ne.parentNode!==fe){fe.appendChild(ne),h.add(S),fe.onpaint=Ye=>{let ut=Ye.changedElements;for(let Fe of h)ut.includes(Fe.image)&&(Fe.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let ut=n.RGBA,Fe=n.RGBA,Mt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ut,Fe,Mt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(ye&&Re){let fe=it(Ce[0]);t.texStorage2D(n.TEXTURE_2D,ct,re,fe.width,fe.height)}for(let fe=0,Ye=Ce.length;fe<Ye;fe++)ie=Ce[fe],ye?Qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,ge,N,ie):t.texImage2D(n.TEXTURE_2D,fe,re,ge,N,ie);S.generateMipmaps=!1}else if(ye){if(Re){let fe=it(ne);t.texStorage2D(n.TEXTURE_2D,ct,re,fe.width,fe.height)}Qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,N,ne)}else t.texImage2D(n.TEXTURE_2D,0,re,ge,N,ne);T(S)&&S.mipmapsAutoUpdate===!0&&y(pe),Te.__version=be.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Be(R,S,X){if(S.image.length!==6)return;let pe=rt(R,S),oe=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let be=i.get(oe);if(oe.version!==be.__version||pe===!0){t.activeTexture(n.TEXTURE0+X);let Te=_t.getPrimaries(_t.workingColorSpace),te=S.colorSpace===Cn?null:_t.getPrimaries(S.colorSpace),ne=S.colorSpace===Cn||Te===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let ge=S.isCompressedTexture||S.image[0].isCompressedTexture,N=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Fe=0;Fe<6;Fe++)!ge&&!N?re[Fe]=v(S.image[Fe],!0,r.maxCubemapSize):re[Fe]=N?S.image[Fe].image:S.image[Fe],re[Fe]=Ke(S,re[Fe]);let ie=re[0],Ce=s.convert(S.format,S.colorSpace),ye=s.convert(S.type),Re=A(S.internalFormat,Ce,ye,S.normalized,S.colorSpace),Qe=S.isVideoTexture!==!0,ct=be.__version===void 0||pe===!0,fe=oe.dataReady,Ye=w(S,ie);at(n.TEXTURE_CUBE_MAP,S);let ut;if(S.isDepthTexture){if(Re=x(S.format===gn,S.type),ct)if(Qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Re,ie.width,ie.height);else for(let Fe=0;Fe<6;Fe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,0,Re,ie.width,ie.height,0,Ce,ye,null)}else if(ge){Qe&&ct&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ye,Re,ie.width,ie.height);for(let Fe=0;Fe<6;Fe++){ut=re[Fe].mipmaps;for(let Mt=0;Mt<ut.length;Mt++){let Xt=ut[Mt];S.format!==Hi?Ce!==null?Qe?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt,0,0,Xt.width,Xt.height,Ce,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt,Re,Xt.width,Xt.height,0,Xt.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt,0,0,Xt.width,Xt.height,Ce,ye,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt,Re,Xt.width,Xt.height,0,Ce,ye,Xt.data)}}}else{if(ut=S.mipmaps,Qe&&ct){ut.length>0&&Ye++;let Fe=it(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ye,Re,Fe.width,Fe.height)}for(let Fe=0;Fe<6;Fe++)if(N){Qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,0,0,0,re[Fe].width,re[Fe].height,Ce,ye,re[Fe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,0,Re,re[Fe].width,re[Fe].height,0,Ce,ye,re[Fe].data);for(let Mt=0;Mt<ut.length;Mt++){let Yi=ut[Mt].image[Fe].image;Qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt+1,0,0,Yi.width,Yi.height,Ce,ye,Yi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt+1,Re,Yi.width,Yi.height,0,Ce,ye,Yi.data)}}else{Qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,0,0,0,Ce,ye,re[Fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,0,Re,Ce,ye,re[Fe]);for(let Mt=0;Mt<ut.length;Mt++){let Xt=ut[Mt];Qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt+1,0,0,Ce,ye,Xt.image[Fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Fe,Mt+1,Re,Ce,ye,Xt.image[Fe])}}}T(S)&&S.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),be.__version=oe.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Ie(R,S,X,pe,oe,be){let Te=s.convert(X.format,X.colorSpace),te=s.convert(X.type),ne=A(X.internalFormat,Te,te,X.normalized,X.colorSpace),ge=i.get(S),N=i.get(X);if(N.__renderTarget=S,!ge.__hasExternalTextures){let re=Math.max(1,S.width>>be),ie=Math.max(1,S.height>>be);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,be,ne,re,ie,S.depth,0,Te,te,null):t.texImage2D(oe,be,ne,re,ie,0,Te,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Ee(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,oe,N.__webglTexture,0,ht(S)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,pe,oe,N.__webglTexture,be),t.bindFramebuffer(n.FRAMEBUFFER,null)}function nt(R,S,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let pe=S.depthTexture,oe=pe&&pe.isDepthTexture?pe.type:null,be=x(S.stencilBuffer,oe),Te=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(S),be,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(S),be,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,be,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Te,n.RENDERBUFFER,R)}else{let pe=S.textures;for(let oe=0;oe<pe.length;oe++){let be=pe[oe],Te=s.convert(be.format,be.colorSpace),te=s.convert(be.type),ne=A(be.internalFormat,Te,te,be.normalized,be.colorSpace);Ee(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(S),ne,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(S),ne,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ne,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ke(R,S,X){let pe=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(S.depthTexture);oe.__renderTarget=S;let be=pe?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||be.width!==S.width||be.height!==S.height)&&(be.width=S.width,be.height=S.height,S.depthTexture.needsUpdate=!0),pe?we(S.depthTexture,0):xe(S.depthTexture,0);let Te=oe.__webglTexture,te=ht(S),ne=pe?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,ge=S.depthTexture.format===gn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===nn)Ee(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ne,Te,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ne,Te,0);else if(S.depthTexture.format===gn)Ee(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ne,Te,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ne,Te,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gt(R){let S=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let pe=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),pe){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,pe.removeEventListener("dispose",oe)};pe.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=pe}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let pe=0;pe<6;pe++)ke(S.__webglFramebuffer[pe],R,pe);else R.texture.mipmaps.length>0?ke(S.__webglFramebuffer[0],R,0):ke(S.__webglFramebuffer,R,0);else if(X){S.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[pe]),S.__webglDepthbuffer[pe]===void 0)S.__webglDepthbuffer[pe]=n.createRenderbuffer(),nt(S.__webglDepthbuffer[pe],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=S.__webglDepthbuffer[pe];n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,be)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),nt(S.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,be)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function pt(R,S,X){let pe=i.get(R);S!==void 0&&Ie(pe.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&gt(R)}function yt(R){let S=R.texture,X=i.get(R),pe=i.get(S);R.addEventListener("dispose",z),B(R);let oe=R.textures,be=R.isWebGLCubeRenderTarget===!0,Te=oe.length>1;if(Te||(pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture()),pe.__version=S.version,o.memory.textures++),be){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<S.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(Te)for(let te=0,ne=oe.length;te<ne;te++){let ge=i.get(oe[te]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Ee(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ne=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let ge=s.convert(ne.format,ne.colorSpace),N=s.convert(ne.type),re=A(ne.internalFormat,ge,N,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),ie=ht(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),nt(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(be){t.bindTexture(n.TEXTURE_CUBE_MAP,pe.__webglTexture),at(n.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)Ie(X.__webglFramebuffer[te][ne],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Ie(X.__webglFramebuffer[te],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(S)?y(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(Te){for(let te=0,ne=oe.length;te<ne;te++){let ge=oe[te],N=i.get(ge),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,N.__webglTexture),at(re,ge),Ie(X.__webglFramebuffer,R,ge,n.COLOR_ATTACHMENT0+te,re,0),T(ge)&&y(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,pe.__webglTexture),at(te,S),S.mipmaps.length>0)for(let ne=0;ne<S.mipmaps.length;ne++)Ie(X.__webglFramebuffer[ne],R,S,n.COLOR_ATTACHMENT0,te,ne);else Ie(X.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,te,0);T(S)?y(te):S.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&gt(R)}function U(R){let S=R.textures;for(let X=0,pe=S.length;X<pe;X++){let oe=S[X];if(T(oe)&&oe.mipmapsAutoUpdate===!0){let be=C(R),Te=i.get(oe).__webglTexture;t.bindTexture(be,Te),y(be),t.unbindTexture()}}}let Se=[];function qe(R){if(R.samples>0){if(Ee(R)===!1){let S=R.textures,X=R.width,pe=R.height,oe=n.COLOR_BUFFER_BIT,be=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Te=i.get(R),te=S.length>1;if(te)for(let ge=0;ge<S.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Te.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglFramebuffer);for(let ge=0;ge<S.length;ge++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Te.__webglColorRenderbuffer[ge]);let N=i.get(S[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,N,0)}n.blitFramebuffer(0,0,X,pe,0,0,X,pe,oe,n.NEAREST),l===!0&&(Se.length=0,Se.push(n.COLOR_ATTACHMENT0+ge),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Se.push(be),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Se))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let ge=0;ge<S.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,Te.__webglColorRenderbuffer[ge]);let N=i.get(S[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,N,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ht(R){return Math.min(r.maxSamples,R.samples)}function Ee(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Nt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ke(R,S){let X=R.colorSpace,pe=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==ws&&X!==Cn&&(_t.getTransfer(X)===Pt?(pe!==Hi||oe!==ui)&&Xe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):bt("WebGLTextures: Unsupported texture color space:",X)),S}function it(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ee,this.setTextureUnits=de,this.setTexture2D=xe,this.setTexture2DArray=ve,this.setTexture3D=De,this.setTextureCube=we,this.rebindTextures=pt,this.setupRenderTarget=yt,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=gt,this.setupFrameBufferTexture=Ie,this.useMultisampledRTT=Ee,this.dispose=H}function q_(n,e){function t(i,r=Cn){let s,o=_t.getTransfer(r);if(i===ui)return n.UNSIGNED_BYTE;if(i===fo)return n.UNSIGNED_SHORT_4_4_4_4;if(i===po)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Dc)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ic)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Pc)return n.BYTE;if(i===Lc)return n.SHORT;if(i===Er)return n.UNSIGNED_SHORT;if(i===ho)return n.INT;if(i===Li)return n.UNSIGNED_INT;if(i===bi)return n.FLOAT;if(i===Di)return n.HALF_FLOAT;if(i===Fc)return n.ALPHA;if(i===Uc)return n.RGB;if(i===Hi)return n.RGBA;if(i===nn)return n.DEPTH_COMPONENT;if(i===gn)return n.DEPTH_STENCIL;if(i===mo)return n.RED;if(i===go)return n.RED_INTEGER;if(i===xn)return n.RG;if(i===xo)return n.RG_INTEGER;if(i===_o)return n.RGBA_INTEGER;if(i===vo||i===Mo||i===yo||i===So)if(o===Pt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===vo)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Mo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===yo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===So)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===vo)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Mo)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===yo)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===So)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Da||i===Ia||i===Fa||i===Ua)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===Da)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ia)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Fa)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ua)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Na||i===Oa||i===Ba||i===ka||i===za||i===Ss||i===Ga)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Na||i===Oa)return o===Pt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Ba)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===ka)return s.COMPRESSED_R11_EAC;if(i===za)return s.COMPRESSED_SIGNED_R11_EAC;if(i===Ss)return s.COMPRESSED_RG11_EAC;if(i===Ga)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ha||i===Va||i===Wa||i===Xa||i===qa||i===Ya||i===$a||i===Ka||i===Za||i===Ja||i===Qa||i===ja||i===el||i===tl)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Ha)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Va)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Wa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Xa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===qa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ya)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===$a)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ka)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Za)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ja)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Qa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ja)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===el)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===tl)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===il||i===nl||i===rl)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===il)return o===Pt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===nl)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===rl)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===sl||i===ol||i===bs||i===al)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===sl)return s.COMPRESSED_RED_RGTC1_EXT;if(i===ol)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===bs)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===al)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Xn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Pw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Lw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Bu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Wo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new hi({vertexShader:Pw,fragmentShader:Lw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new At(new Nn(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var ku=class extends Vi{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,m=null,M=typeof XRWebGLBinding<"u",d=new Bu,g={},v=t.getContextAttributes(),T=null,y=null,C=[],A=[],x=new le,w=null,B=null,D=new Ui;D.viewport=new It;let L=new Ui;L.viewport=new It;let z=[D,L],W=new Lu,I=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let xe=C[j];return xe===void 0&&(xe=new Lo,C[j]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(j){let xe=C[j];return xe===void 0&&(xe=new Lo,C[j]=xe),xe.getGripSpace()},this.getHand=function(j){let xe=C[j];return xe===void 0&&(xe=new Lo,C[j]=xe),xe.getHandSpace()};function q(j){let xe=A.indexOf(j.inputSource);if(xe===-1)return;let ve=C[xe];ve!==void 0&&(ve.update(j.inputSource,j.frame,c||o),ve.dispatchEvent({type:j.type,data:j.inputSource}))}function G(){r.removeEventListener("select",q),r.removeEventListener("selectstart",q),r.removeEventListener("selectend",q),r.removeEventListener("squeeze",q),r.removeEventListener("squeezestart",q),r.removeEventListener("squeezeend",q),r.removeEventListener("end",G),r.removeEventListener("inputsourceschange",ce);for(let j=0;j<C.length;j++){let xe=A[j];xe!==null&&(A[j]=null,C[j].disconnect(xe))}I=null,H=null,d.reset();for(let j in g)delete g[j];if(e.setRenderTarget(T),p=null,f=null,h=null,r=null,y=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),B!==null){let j=B.camera;j.fov=B.fov,j.zoom=B.zoom,j.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){s=j,i.isPresenting===!0&&Xe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&Xe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&M&&(h=new XRWebGLBinding(r,t)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(j){if(r=j,r!==null){if(T=e.getRenderTarget(),r.addEventListener("select",q),r.addEventListener("selectstart",q),r.addEventListener("selectend",q),r.addEventListener("squeeze",q),r.addEventListener("squeezestart",q),r.addEventListener("squeezeend",q),r.addEventListener("end",G),r.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,De=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?gn:nn,De=v.stencil?Xn:Li);let He={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(He),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new zi(f.textureWidth,f.textureHeight,{format:Hi,type:ui,depthTexture:new Sn(f.textureWidth,f.textureHeight,De,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,ve),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),y=new zi(p.framebufferWidth,p.framebufferHeight,{format:Hi,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),ue.setContext(r),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ce(j){for(let xe=0;xe<j.removed.length;xe++){let ve=j.removed[xe],De=A.indexOf(ve);De>=0&&(A[De]=null,C[De].disconnect(ve))}for(let xe=0;xe<j.added.length;xe++){let ve=j.added[xe],De=A.indexOf(ve);if(De===-1){for(let He=0;He<C.length;He++)if(He>=A.length){A.push(ve),De=He;break}else if(A[He]===null){A[He]=ve,De=He;break}if(De===-1)break}let we=C[De];we&&we.connect(ve)}}function K(j,xe){xe===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(xe.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(r===null)return;let xe=j.near,ve=j.far;d.texture!==null&&(d.depthNear>0&&(xe=d.depthNear),d.depthFar>0&&(ve=d.depthFar)),W.near=L.near=D.near=xe,W.far=L.far=D.far=ve,(I!==W.near||H!==W.far)&&(r.updateRenderState({depthNear:W.near,depthFar:W.far}),I=W.near,H=W.far),W.layers.mask=j.layers.mask|6,D.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let De=j.parent,we=W.cameras;K(W,De);for(let He=0;He<we.length;He++)K(we[He],De);W.projectionMatrix.copy(D.projectionMatrix),W.projectionMatrixInverse.copy(D.projectionMatrixInverse),B===null&&j.isPerspectiveCamera&&(B={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,W,De)};function Q(j,xe,ve){ve===null?j.matrix.copy(xe.matrixWorld):(j.matrix.copy(ve.matrixWorld),j.matrix.invert(),j.matrix.multiply(xe.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(xe.projectionMatrix),j.projectionMatrixInverse.copy(xe.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=cl*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=j)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(W)},this.getCameraTexture=function(j){return g[j]};let ee=null;function de(j,xe){if(u=xe.getViewerPose(c||o),m=xe,u!==null){let ve=u.views;p!==null&&(e.setRenderTargetFramebuffer(y,p.framebuffer),e.setRenderTarget(y));let De=!1;ve.length!==W.cameras.length&&(W.cameras.length=0,De=!0);for(let Je=0;Je<ve.length;Je++){let at=ve[Je],rt=null;if(p!==null)rt=p.getViewport(at);else{let Me=h.getViewSubImage(f,at);rt=Me.viewport,Je===0&&(e.setRenderTargetTextures(y,Me.colorTexture,Me.depthStencilTexture),e.setRenderTarget(y))}let se=z[Je];se===void 0&&(se=new Ui,se.layers.enable(Je),se.viewport=new It,z[Je]=se),se.matrix.fromArray(at.transform.matrix),se.matrix.decompose(se.position,se.quaternion,se.scale),se.projectionMatrix.fromArray(at.projectionMatrix),se.projectionMatrixInverse.copy(se.projectionMatrix).invert(),se.viewport.set(rt.x,rt.y,rt.width,rt.height),Je===0&&(W.matrix.copy(se.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),De===!0&&W.cameras.push(se)}let we=r.enabledFeatures;if(we&&we.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&M){h=i.getBinding();let Je=h.getDepthInformation(ve[0]);Je&&Je.isValid&&Je.texture&&d.init(Je,r.renderState)}if(we&&we.includes("camera-access")&&M){e.state.unbindTexture(),h=i.getBinding();for(let Je=0;Je<ve.length;Je++){let at=ve[Je].camera;if(at){let rt=g[at];rt||(rt=new Wo,g[at]=rt);let se=h.getCameraImage(at);rt.sourceTexture=se}}}}for(let ve=0;ve<C.length;ve++){let De=A[ve],we=C[ve];De!==null&&we!==void 0&&we.update(De,xe,c||o)}ee&&ee(j,xe),xe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:xe}),m=null}let ue=new Du;ue.setAnimationLoop(de),this.setAnimationLoop=function(j){ee=j},this.dispose=function(){}}};var Dw=new st,Y_=new et;Y_.set(-1,0,0,0,1,0,0,0,1);function $_(n,e){function t(d,g){d.matrixAutoUpdate===!0&&d.updateMatrix(),g.value.copy(d.matrix)}function i(d,g){g.color.getRGB(d.fogColor.value,bu(n)),g.isFog?(d.fogNear.value=g.near,d.fogFar.value=g.far):g.isFogExp2&&(d.fogDensity.value=g.density)}function r(d,g,v,T,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(d,g):g.isMeshLambertMaterial?(s(d,g),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(d,g),h(d,g)):g.isMeshPhongMaterial?(s(d,g),u(d,g),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(d,g),f(d,g),g.isMeshPhysicalMaterial&&p(d,g,y)):g.isMeshMatcapMaterial?(s(d,g),m(d,g)):g.isMeshDepthMaterial?s(d,g):g.isMeshDistanceMaterial?(s(d,g),M(d,g)):g.isMeshNormalMaterial?s(d,g):g.isLineBasicMaterial?(o(d,g),g.isLineDashedMaterial&&a(d,g)):g.isPointsMaterial?l(d,g,v,T):g.isSpriteMaterial?c(d,g):g.isShadowMaterial?(d.color.value.copy(g.color),d.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(d,g){d.opacity.value=g.opacity,g.color&&d.diffuse.value.copy(g.color),g.emissive&&d.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(d.map.value=g.map,t(g.map,d.mapTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.bumpMap&&(d.bumpMap.value=g.bumpMap,t(g.bumpMap,d.bumpMapTransform),d.bumpScale.value=g.bumpScale,g.side===ei&&(d.bumpScale.value*=-1)),g.normalMap&&(d.normalMap.value=g.normalMap,t(g.normalMap,d.normalMapTransform),d.normalScale.value.copy(g.normalScale),g.side===ei&&d.normalScale.value.negate()),g.displacementMap&&(d.displacementMap.value=g.displacementMap,t(g.displacementMap,d.displacementMapTransform),d.displacementScale.value=g.displacementScale,d.displacementBias.value=g.displacementBias),g.emissiveMap&&(d.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,d.emissiveMapTransform)),g.specularMap&&(d.specularMap.value=g.specularMap,t(g.specularMap,d.specularMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest);let v=e.get(g),T=v.envMap,y=v.envMapRotation;T&&(d.envMap.value=T,d.envMapRotation.value.setFromMatrix4(Dw.makeRotationFromEuler(y)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(Y_),d.reflectivity.value=g.reflectivity,d.ior.value=g.ior,d.refractionRatio.value=g.refractionRatio),g.lightMap&&(d.lightMap.value=g.lightMap,d.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,d.lightMapTransform)),g.aoMap&&(d.aoMap.value=g.aoMap,d.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,d.aoMapTransform))}function o(d,g){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,g.map&&(d.map.value=g.map,t(g.map,d.mapTransform))}function a(d,g){d.dashSize.value=g.dashSize,d.totalSize.value=g.dashSize+g.gapSize,d.scale.value=g.scale}function l(d,g,v,T){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,d.size.value=g.size*v,d.scale.value=T*.5,g.map&&(d.map.value=g.map,t(g.map,d.uvTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest)}function c(d,g){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,d.rotation.value=g.rotation,g.map&&(d.map.value=g.map,t(g.map,d.mapTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest)}function u(d,g){d.specular.value.copy(g.specular),d.shininess.value=Math.max(g.shininess,1e-4)}function h(d,g){g.gradientMap&&(d.gradientMap.value=g.gradientMap)}function f(d,g){d.metalness.value=g.metalness,g.metalnessMap&&(d.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,d.metalnessMapTransform)),d.roughness.value=g.roughness,g.roughnessMap&&(d.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,d.roughnessMapTransform)),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)}function p(d,g,v){d.ior.value=g.ior,g.diffuseRoughness>0&&(d.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),g.sheen>0&&(d.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),d.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(d.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,d.sheenColorMapTransform)),g.sheenRoughnessMap&&(d.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,d.sheenRoughnessMapTransform))),g.clearcoat>0&&(d.clearcoat.value=g.clearcoat,d.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(d.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,d.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(d.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ei&&d.clearcoatNormalScale.value.negate())),g.dispersion>0&&(d.dispersion.value=g.dispersion),g.retroreflectivity>0&&(d.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(d.iridescence.value=g.iridescence,d.iridescenceIOR.value=g.iridescenceIOR,d.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(d.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,d.iridescenceMapTransform)),g.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),g.transmission>0&&(d.transmission.value=g.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(d.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,d.transmissionMapTransform)),d.thickness.value=g.thickness,g.thicknessMap&&(d.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=g.attenuationDistance,d.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(d.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(d.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=g.specularIntensity,d.specularColor.value.copy(g.specularColor),g.specularColorMap&&(d.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,d.specularColorMapTransform)),g.specularIntensityMap&&(d.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,d.specularIntensityMapTransform))}function m(d,g){g.matcap&&(d.matcap.value=g.matcap)}function M(d,g){let v=e.get(g).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function K_(n,e,t,i){let r={},s={};function o(v,T){let y=T.program;i.uniformBlockBinding(v,y,r[v.id])}function a(v,T){let y=r[v.id];y===void 0&&(m(v),y=l(v),r[v.id]=y,v.addEventListener("dispose",d));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;s[v.id]!==A&&(c(v),s[v.id]=A)}function l(v){let T=n.createBuffer(),y=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,y,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=r[v.id],y=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,x=y.length;A<x;A++){let w=y[A];if(Array.isArray(w))for(let B=0,D=w.length;B<D;B++)u(w[B],A,B,C);else u(w,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,T,y,C){if(f(v,T,y,C)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let w=0;for(let B=0;B<x.length;B++){let D=x[B],L=M(D,!0);h(D,v.__data,w),w+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function h(v,T,y){typeof v=="number"||typeof v=="boolean"?T[y]=v:v.isMatrix3?(T[y]=v.elements[0],T[y+1]=v.elements[1],T[y+2]=v.elements[2],T[y+3]=0,T[y+4]=v.elements[3],T[y+5]=v.elements[4],T[y+6]=v.elements[5],T[y+7]=0,T[y+8]=v.elements[6],T[y+9]=v.elements[7],T[y+10]=v.elements[8],T[y+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-y),y):v.toArray(T,y)}function f(v,T,y,C){let A=v.value,x=T+"_"+y;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let w=C[x],B=!1;for(let D=0;D<A.length;D++)p(A[D],w,D)===!0&&(B=!0);return B}return p(A,C,x)}function p(v,T,y){if(T[y]===void 0)return typeof v=="number"||typeof v=="boolean"?T[y]=v:ArrayBuffer.isView(v)?T[y]=v.slice():T[y]=v.clone(),!0;{let C=T[y];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[y]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function m(v){let T=v.uniforms,y=0,C=16;for(let x=0,w=T.length;x<w;x++){let B=Array.isArray(T[x])?T[x]:[T[x]];for(let D=0,L=B.length;D<L;D++){let z=B[D],W=Array.isArray(z.value)?z.value:[z.value],I=Array.isArray(T[x])||Array.isArray(z.value),H=y;for(let G=0,ce=W.length;G<ce;G++){let K=W[G],Q=M(K,I),ee=y%C,de=ee%Q.boundary,ue=ee+de;y+=de,ue!==0&&C-ue<Q.storage&&(y+=C-ue),G===0&&(H=y),y+=Q.storage}let q=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new q((y-H)/Float32Array.BYTES_PER_ELEMENT),z.__offset=H}}let A=y%C;return A>0&&(y+=C-A),v.__size=y,v.__cache={},this}function M(v,T){let y={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(y.boundary=4,y.storage=4):v.isVector2?(y.boundary=8,y.storage=8):v.isVector3||v.isColor?(y.boundary=16,y.storage=12):v.isVector4?(y.boundary=16,y.storage=16):v.isMatrix3?(y.boundary=16,y.storage=48):v.isMatrix4?(y.boundary=16,y.storage=64):v.isTexture?Xe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(y.boundary=16,y.storage=v.byteLength):Xe("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function d(v){let T=v.target;T.removeEventListener("dispose",d),n.deleteBuffer(r[T.id]),delete r[T.id],delete s[T.id]}function g(){for(let v in r)n.deleteBuffer(r[v]);r={},s={}}return{bind:o,update:a,dispose:g}}var Iw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),mr=null;function Z_(){return mr===null&&(mr=new zo(Iw,16,16,xn,Di),mr.name="DFG_LUT",mr.minFilter=xi,mr.magFilter=xi,mr.wrapS=tn,mr.wrapT=tn,mr.generateMipmaps=!1,mr.needsUpdate=!0),mr}var Cl=class{constructor(e={}){let{canvas:t=Lm(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:p=ui}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let M=p,d=new Set([_o,xo,go]),g=new Set([ui,Li,Er,Xn,fo,po]),v=new Uint32Array(4),T=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],w=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=dn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,z=null,W=null,I=null,H=null;this._outputColorSpace=wi;let q=0,G=0,ce=null,K=-1,Q=null,ee=new It,de=new It,ue=null,j=new tt(0),xe=0,ve=t.width,De=t.height,we=1,He=null,ot=null,Je=new It(0,0,ve,De),at=new It(0,0,ve,De),rt=!1,se=new Qn,Me=new hu,_e=!1,Be=!1,Ie=new st,nt=new O,ke=new It,gt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},pt=!1;function yt(){return ce===null?we:1}let U=i;function Se(E,k){return t.getContext(E,k)}let qe,ht,Ee,Nt,Ke,it,R,S,X,pe,oe,be,Te,te,ne,ge,N,re,ie,Ce,ye,Re,Qe;try{let E={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ye,!1),t.addEventListener("webglcontextrestored",ut,!1),t.addEventListener("webglcontextcreationerror",Fe,!1),U===null){let k="webgl2";if(U=Se(k,E),U===null)throw Se(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ct()}catch(E){throw t.removeEventListener("webglcontextlost",Ye,!1),t.removeEventListener("webglcontextrestored",ut,!1),t.removeEventListener("webglcontextcreationerror",Fe,!1),bt("WebGLRenderer: "+E.message),E}function ct(){qe=new o_(U),qe.init(),ye=new q_(U,qe),ht=new Jx(U,qe,e,ye),Ee=new W_(U,qe),ht.reversedDepthBuffer&&f&&Ee.buffers.depth.setReversed(!0),W=U.createFramebuffer(),I=U.createFramebuffer(),H=U.createFramebuffer(),Nt=new c_(U),Ke=new I_,it=new X_(U,qe,Ee,Ke,ht,ye,Nt),R=new s_(D),S=new yg(U),Re=new Kx(U,S),X=new a_(U,S,Nt,Re),pe=new h_(U,X,S,Re,Nt),re=new u_(U,ht,it),ne=new Qx(Ke),oe=new D_(D,R,qe,ht,Re,ne),be=new $_(D,Ke),Te=new N_,te=new k_(qe),N=new $x(D,R,Ee,pe,m,l),ge=new V_(D,pe,ht),Qe=new K_(U,Nt,ht,Ee),ie=new Zx(U,qe,Nt),Ce=new l_(U,qe,Nt),Nt.programs=oe.programs,D.capabilities=ht,D.extensions=qe,D.properties=Ke,D.renderLists=Te,D.shadowMap=ge,D.state=Ee,D.info=Nt}M!==ui&&(B=new f_(M,t.width,t.height,a,r,s));let fe=new ku(D,U);this.xr=fe,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let E=qe.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=qe.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(ve,De,!1))},this.getSize=function(E){return E.set(ve,De)},this.setSize=function(E,k,J=!0){if(fe.isPresenting){Xe("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=E,De=k,t.width=Math.floor(E*we),t.height=Math.floor(k*we),J===!0&&(t.style.width=E+"px",t.style.height=k+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,E,k)},this.getDrawingBufferSize=function(E){return E.set(ve*we,De*we).floor()},this.setDrawingBufferSize=function(E,k,J){ve=E,De=k,we=J,t.width=Math.floor(E*J),t.height=Math.floor(k*J),this.setViewport(0,0,E,k)},this.setEffects=function(E){if(M===ui){bt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let k=0;k<E.length;k++)if(E[k].isOutputPass===!0){Xe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ee)},this.getViewport=function(E){return E.copy(Je)},this.setViewport=function(E,k,J,Y){E.isVector4?Je.set(E.x,E.y,E.z,E.w):Je.set(E,k,J,Y),Ee.viewport(ee.copy(Je).multiplyScalar(yt()).round())},this.getScissor=function(E){return E.copy(at)},this.setScissor=function(E,k,J,Y){E.isVector4?at.set(E.x,E.y,E.z,E.w):at.set(E,k,J,Y),Ee.scissor(de.copy(at).multiplyScalar(yt()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(E){Ee.setScissorTest(rt=E)},this.setOpaqueSort=function(E){He=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(E=!0,k=!0,J=!0){let Y=0;if(E){let $=!1;if(ce!==null){let Pe=ce.texture.format;$=d.has(Pe)}if($){let Pe=ce.texture.type,Ue=g.has(Pe),Le=N.getClearColor(),Oe=N.getClearAlpha(),Ze=Le.r,ft=Le.g,wt=Le.b;Ue?(v[0]=Ze,v[1]=ft,v[2]=wt,v[3]=Oe,U.clearBufferuiv(U.COLOR,0,v)):(T[0]=Ze,T[1]=ft,T[2]=wt,T[3]=Oe,U.clearBufferiv(U.COLOR,0,T))}else Y|=U.COLOR_BUFFER_BIT}k&&(Y|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(Y|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&U.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),z=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Ye,!1),t.removeEventListener("webglcontextrestored",ut,!1),t.removeEventListener("webglcontextcreationerror",Fe,!1),N.dispose(),Te.dispose(),te.dispose(),it.dispose(),Ke.dispose(),R.dispose(),pe.dispose(),X.dispose(),Re.dispose(),Qe.dispose(),oe.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",Ul),fe.removeEventListener("sessionend",tr),gr.stop()};function Ye(E){E.preventDefault(),qh("WebGLRenderer: Context Lost."),L=!0}function ut(){qh("WebGLRenderer: Context Restored."),L=!1;let E=Nt.autoReset,k=ge.enabled,J=ge.autoUpdate,Y=ge.needsUpdate,$=ge.type;ct(),Nt.autoReset=E,ge.enabled=k,ge.autoUpdate=J,ge.needsUpdate=Y,ge.type=$}function Fe(E){bt("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Mt(E){let k=E.target;k.removeEventListener("dispose",Mt),Xt(k)}function Xt(E){Yi(E),Ke.remove(E)}function Yi(E){let k=Ke.get(E).programs;k!==void 0&&(k.forEach(function(J){oe.releaseProgram(J)}),E.isShaderMaterial&&oe.releaseShaderCache(E))}this.renderBufferDirect=function(E,k,J,Y,$,Pe){k===null&&(k=gt);let Ue=$.isMesh&&$.matrixWorld.determinantAffine()<0,Le=la(E,k,J,Y,$);Ee.setMaterial(Y,Ue);let Oe=J.index,Ze=1;if(Y.wireframe===!0){if(Oe=X.getWireframeAttribute(J),Oe===void 0)return;Ze=2}let ft=J.drawRange,wt=J.attributes.position,$e=ft.start*Ze,Et=(ft.start+ft.count)*Ze;Pe!==null&&($e=Math.max($e,Pe.start*Ze),Et=Math.min(Et,(Pe.start+Pe.count)*Ze)),Oe!==null?($e=Math.max($e,0),Et=Math.min(Et,Oe.count)):wt!=null&&($e=Math.max($e,0),Et=Math.min(Et,wt.count));let jt=Et-$e;if(jt<0||jt===1/0)return;Re.setup($,Y,Le,J,Oe);let Bt,kt=ie;if(Oe!==null&&(Bt=S.get(Oe),kt=Ce,kt.setIndex(Bt)),$.isMesh)Y.wireframe===!0?(Ee.setLineWidth(Y.wireframeLinewidth*yt()),kt.setMode(U.LINES)):kt.setMode(U.TRIANGLES);else if($.isLine){let vi=Y.linewidth;vi===void 0&&(vi=1),Ee.setLineWidth(vi*yt()),$.isLineSegments?kt.setMode(U.LINES):$.isLineLoop?kt.setMode(U.LINE_LOOP):kt.setMode(U.LINE_STRIP)}else $.isPoints?kt.setMode(U.POINTS):$.isSprite&&kt.setMode(U.TRIANGLES);if($.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))kt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let vi=$._multiDrawStarts,Ve=$._multiDrawCounts,fi=$._multiDrawCount,Rt=Oe?S.get(Oe).bytesPerElement:1,_r=Ke.get(Y).currentProgram.getUniforms();for(let pi=0;pi<fi;pi++)_r.setValue(U,"_gl_DrawID",pi),kt.render(vi[pi]/Rt,Ve[pi])}else if($.isInstancedMesh)kt.renderInstances($e,jt,$.count);else if(J.isInstancedBufferGeometry){let vi=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ve=Math.min(J.instanceCount,vi);kt.renderInstances($e,jt,Ve)}else kt.render($e,jt)};function sa(E,k,J,Y){z!==null&&E.isNodeMaterial&&z.setObject(Y,E),_e===!0&&ne.setState(E,J,!1),E.transparent===!0&&E.side===Si&&E.forceSinglePass===!1?(E.side=ei,E.needsUpdate=!0,ir(E,k,Y),E.side=Rn,E.needsUpdate=!0,ir(E,k,Y),E.side=Si):ir(E,k,Y)}this.compile=function(E,k,J=null){J===null&&(J=E),z!==null&&z.renderStart(E,k,J),A=te.get(J),A.init(k),w.push(A),J.traverseVisible(function($){$.isLight&&$.layers.test(k.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),E!==J&&E.traverseVisible(function($){$.isLight&&$.layers.test(k.layers)&&(A.pushLight($),$.castShadow&&A.pushShadow($))}),A.setupLights(),z!==null&&z.updateLights(A.state.lightsArray),Be=this.localClippingEnabled,_e=ne.init(this.clippingPlanes,Be),_e===!0&&ne.setGlobalState(this.clippingPlanes,k),z!==null&&ge.render(A.state.shadowsArray,J,k);let Y=new Set;return E.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Pe=$.material;if(Pe)if(Array.isArray(Pe))for(let Ue=0;Ue<Pe.length;Ue++){let Le=Pe[Ue];sa(Le,J,k,$),Y.add(Le)}else sa(Pe,J,k,$),Y.add(Pe)}),A=w.pop(),z!==null&&z.renderEnd(),Y},this.compileAsync=function(E,k,J=null){let Y=this.compile(E,k,J);return new Promise($=>{function Pe(){if(Y.forEach(function(Ue){let Oe=Ke.get(Ue).currentProgram;(Oe===void 0||Oe.isReady())&&Y.delete(Ue)}),Y.size===0){$(E);return}setTimeout(Pe,10)}qe.get("KHR_parallel_shader_compile")!==null?Pe():setTimeout(Pe,10)})};let Ns=null;function Yu(E){Ns&&Ns(E)}function Ul(){gr.stop()}function tr(){gr.start()}let gr=new Du;gr.setAnimationLoop(Yu),typeof self<"u"&&gr.setContext(self),this.setAnimationLoop=function(E){Ns=E,fe.setAnimationLoop(E),E===null?gr.stop():gr.start()},fe.addEventListener("sessionstart",Ul),fe.addEventListener("sessionend",tr),this.render=function(E,k){if(k!==void 0&&k.isCamera!==!0){bt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(E,k);let J=fe.enabled===!0&&fe.isPresenting===!0,Y=B!==null&&(ce===null||J)&&B.begin(D,ce);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(k),k=fe.getCamera()),E.isScene===!0&&E.onBeforeRender(D,E,k,ce),A=te.get(E,w.length),A.init(k),A.state.textureUnits=it.getTextureUnits(),w.push(A),Ie.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Me.setFromArrayCamera(k):se.setFromProjectionMatrix(Ie,ki,k.reversedDepth),Be=this.localClippingEnabled,_e=ne.init(this.clippingPlanes,Be),C=Te.get(E,x.length),C.init(),x.push(C),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Ue=D.xr.getDepthSensingMesh();Ue!==null&&xr(Ue,k,-1/0,D.sortObjects)}xr(E,k,0,D.sortObjects),C.finish(),z!==null&&z.updateLights(A.state.lightsArray),D.sortObjects===!0&&C.sort(He,ot),pt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,pt&&N.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),_e===!0&&ne.beginShadows();let $=A.state.shadowsArray;if(ge.render($,E,k),_e===!0&&ne.endShadows(),(Y&&B.hasRenderPass())===!1){let Ue=C.opaque,Le=C.transmissive;if(A.setupLights(),k.isArrayCamera){let Oe=k.cameras;if(Le.length>0)for(let Ze=0,ft=Oe.length;Ze<ft;Ze++){let wt=Oe[Ze];Bn(Ue,Le,E,wt)}pt&&N.render(E);for(let Ze=0,ft=Oe.length;Ze<ft;Ze++){let wt=Oe[Ze];oa(C,E,wt,wt.viewport)}}else Le.length>0&&Bn(Ue,Le,E,k),pt&&N.render(E),oa(C,E,k)}ce!==null&&G===0&&(it.updateMultisampleRenderTarget(ce),it.updateRenderTargetMipmap(ce)),Y&&B.end(D),E.isScene===!0&&E.onAfterRender(D,E,k),Re.resetDefaultState(),K=-1,Q=null,w.pop(),w.length>0?(A=w[w.length-1],it.setTextureUnits(A.state.textureUnits),_e===!0&&ne.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,z!==null&&z.renderEnd()};function xr(E,k,J,Y){if(E.visible===!1)return;if(E.layers.test(k.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(k);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Ue=k.isArrayCamera?Me:se;if(!E.frustumCulled||E.intersectsFrustum(Ue)){Y&&ke.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ie);let Le=pe.update(E),Oe=E.material;Oe.visible&&C.push(E,Le,Oe,J,ke.z,null,k)}}else if(E.isMesh||E.isLine||E.isPoints){let Ue=k.isArrayCamera?Me:se;if(!E.frustumCulled||E.intersectsFrustum(Ue)){let Le=pe.update(E),Oe=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),ke.copy(E.boundingSphere.center)):(Le.boundingSphere===null&&Le.computeBoundingSphere(),ke.copy(Le.boundingSphere.center)),ke.applyMatrix4(E.matrixWorld).applyMatrix4(Ie)),Array.isArray(Oe)){let Ze=Le.groups;for(let ft=0,wt=Ze.length;ft<wt;ft++){let $e=Ze[ft],Et=Oe[$e.materialIndex];Et&&Et.visible&&C.push(E,Le,Et,J,ke.z,$e,k)}}else Oe.visible&&C.push(E,Le,Oe,J,ke.z,null,k)}}}let Pe=E.children;for(let Ue=0,Le=Pe.length;Ue<Le;Ue++)xr(Pe[Ue],k,J,Y)}function oa(E,k,J,Y){let{opaque:$,transmissive:Pe,transparent:Ue}=E;A.setupLightsView(J),_e===!0&&ne.setGlobalState(D.clippingPlanes,J),Y&&Ee.viewport(ee.copy(Y)),$.length>0&&ni($,k,J),Pe.length>0&&ni(Pe,k,J),Ue.length>0&&ni(Ue,k,J),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Bn(E,k,J,Y){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let $e=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new zi(1,1,{generateMipmaps:!0,type:$e?Di:ui,minFilter:mn,samples:Math.max(4,ht.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Pe=A.state.transmissionRenderTarget[Y.id],Ue=Y.viewport||ee;Pe.setSize(Ue.z*D.transmissionResolutionScale,Ue.w*D.transmissionResolutionScale);let Le=D.getRenderTarget(),Oe=D.getActiveCubeFace(),Ze=D.getActiveMipmapLevel();D.setRenderTarget(Pe),D.getClearColor(j),xe=D.getClearAlpha(),xe<1&&D.setClearColor(16777215,.5),D.clear(),pt&&N.render(J);let ft=D.toneMapping;D.toneMapping=dn;let wt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),_e===!0&&ne.setGlobalState(D.clippingPlanes,Y),ni(E,J,Y),it.updateMultisampleRenderTarget(Pe),it.updateRenderTargetMipmap(Pe),qe.has("WEBGL_multisampled_render_to_texture")===!1){let $e=!1;for(let Et=0,jt=k.length;Et<jt;Et++){let Bt=k[Et],{object:kt,geometry:vi,material:Ve,group:fi}=Bt;if(Ve.side===Si&&kt.layers.test(Y.layers)){let Rt=Ve.side;Ve.side=ei,Ve.needsUpdate=!0,li(kt,J,Y,vi,Ve,fi),Ve.side=Rt,Ve.needsUpdate=!0,$e=!0}}$e===!0&&(it.updateMultisampleRenderTarget(Pe),it.updateRenderTargetMipmap(Pe))}D.setRenderTarget(Le,Oe,Ze),D.setClearColor(j,xe),wt!==void 0&&(Y.viewport=wt),D.toneMapping=ft}function ni(E,k,J){let Y=k.isScene===!0?k.overrideMaterial:null;for(let $=0,Pe=E.length;$<Pe;$++){let Ue=E[$],{object:Le,geometry:Oe,group:Ze}=Ue,ft=Ue.material;ft.allowOverride===!0&&Y!==null&&(ft=Y),Le.layers.test(J.layers)&&li(Le,k,J,Oe,ft,Ze)}}function li(E,k,J,Y,$,Pe){z!==null&&$.isNodeMaterial&&z.setObject(E,$),E.onBeforeRender(D,k,J,Y,$,Pe),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),$.onBeforeRender(D,k,J,Y,E,Pe),$.transparent===!0&&$.side===Si&&$.forceSinglePass===!1?($.side=ei,$.needsUpdate=!0,D.renderBufferDirect(J,k,Y,$,E,Pe),$.side=Rn,$.needsUpdate=!0,D.renderBufferDirect(J,k,Y,$,E,Pe),$.side=Si):D.renderBufferDirect(J,k,Y,$,E,Pe),E.onAfterRender(D,k,J,Y,$,Pe)}function ci(E){let k=0;for(let J of E)J.texture!==null&&k++;return k}function ir(E,k,J){k.isScene!==!0&&(k=gt);let Y=Ke.get(E),$=A.state.lights,Pe=A.state.shadowsArray,Ue=$.state.version,Le=oe.getParameters(E,$.state,Pe,k,J,A.state.lightProbeGridArray),Oe=oe.getProgramCacheKey(Le),Ze=Y.programs;Y.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let ft=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Y.envMap=R.get(E.envMap||Y.environment,ft),Y.envMapRotation=Y.environment!==null&&E.envMap===null?k.environmentRotation:E.envMapRotation,Ze===void 0&&(E.addEventListener("dispose",Mt),Ze=new Map,Y.programs=Ze,Y.programVariants=new Map);let wt=Ze.get(Oe);if(wt!==void 0){if(Y.currentProgram===wt&&Y.lightsStateVersion===Ue)return aa(E,Le),wt}else Le.uniforms=oe.getUniforms(E),z!==null&&E.isNodeMaterial&&z.build(E,J,Le),E.onBeforeCompile(Le,D),wt=oe.acquireProgram(Le,Oe),Ze.set(Oe,wt),Y.uniforms=Le.uniforms;let $e=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&($e.clippingPlanes=ne.uniform),aa(E,Le),Y.needsLights=Ur(E),Y.lightsStateVersion=Ue,Y.needsLights&&($e.ambientLightColor.value=$.state.ambient,$e.lightProbe.value=$.state.probe,$e.sunLights.value=$.state.sun,$e.sunLightShadows.value=$.state.sunShadow,$e.directionalLights.value=$.state.directional,$e.directionalLightShadows.value=$.state.directionalShadow,$e.spotLights.value=$.state.spot,$e.spotLightShadows.value=$.state.spotShadow,$e.rectAreaLights.value=$.state.rectArea,$e.ltc_1.value=$.state.rectAreaLTC1,$e.ltc_2.value=$.state.rectAreaLTC2,$e.pointLights.value=$.state.point,$e.pointLightShadows.value=$.state.pointShadow,$e.hemisphereLights.value=$.state.hemi,$e.sunShadowMatrix.value=$.state.sunShadowMatrix,$e.sunShadowCascade.value=$.state.sunShadowCascade,$e.directionalShadowMatrix.value=$.state.directionalShadowMatrix,$e.spotLightMatrix.value=$.state.spotLightMatrix,$e.spotLightMap.value=$.state.spotLightMap,$e.pointShadowMatrix.value=$.state.pointShadowMatrix),Y.numLightProbeGrids=ci(A.state.lightProbeGridArray),Y.currentProgram=wt,Y.uniformsList=null,wt}function sn(E,k,J,Y,$){let Pe=Ke.get(E),Ue=Pe.currentProgram.id+","+Y+","+$,Le=Pe.programVariants.get(Ue);return Le===void 0?(Le=ir(E,k,J),Pe.programVariants.set(Ue,Le)):(Pe.currentProgram=Le,Pe.uniformsList=null,Pe.outputColorSpace=Y,Pe.toneMapping=$),Le}function Fr(E){if(E.uniformsList===null){let k=E.currentProgram.getUniforms();E.uniformsList=ls.seqWithValue(k.seq,E.uniforms)}return E.uniformsList}function aa(E,k){let J=Ke.get(E);J.outputColorSpace=k.outputColorSpace,J.batching=k.batching,J.batchingColor=k.batchingColor,J.instancing=k.instancing,J.instancingColor=k.instancingColor,J.instancingMorph=k.instancingMorph,J.skinning=k.skinning,J.morphTargets=k.morphTargets,J.morphNormals=k.morphNormals,J.morphColors=k.morphColors,J.morphTargetsCount=k.morphTargetsCount,J.numClippingPlanes=k.numClippingPlanes,J.numIntersection=k.numClipIntersection,J.vertexAlphas=k.vertexAlphas,J.vertexTangents=k.vertexTangents,J.toneMapping=k.toneMapping}function la(E,k,J,Y,$){k.isScene!==!0&&(k=gt),it.resetTextureUnits();let Pe=k.fog,Ue=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Le=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:_t.workingColorSpace,Oe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ze=R.get(Y.envMap||Ue,Oe),ft=Y.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,wt=!!J.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),$e=!!J.morphAttributes.position,Et=!!J.morphAttributes.normal,jt=!!J.morphAttributes.color,Bt=dn;Y.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Bt=D.toneMapping);let kt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,vi=kt!==void 0?kt.length:0,Ve=Ke.get(Y),fi=A.state.lights;if(_e===!0&&(Be===!0||E!==Q)){let zt=E===Q&&Y.id===K;ne.setState(Y,E,zt)}let Rt=!1,_r=!1;Y.version===Ve.__version?Ve.needsLights&&Ve.lightsStateVersion!==fi.state.version||$.isBatchedMesh&&Ve.batching===!1||!$.isBatchedMesh&&Ve.batching===!0||$.isBatchedMesh&&Ve.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Ve.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Ve.instancing===!1||!$.isInstancedMesh&&Ve.instancing===!0||$.isSkinnedMesh&&Ve.skinning===!1||!$.isSkinnedMesh&&Ve.skinning===!0||$.isInstancedMesh&&Ve.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Ve.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Ve.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Ve.instancingMorph===!1&&$.morphTexture!==null||Ve.envMap!==Ze||Y.fog===!0&&Ve.fog!==Pe||Ve.numClippingPlanes!==void 0&&(Ve.numClippingPlanes!==ne.numPlanes||Ve.numIntersection!==ne.numIntersection)||Ve.vertexAlphas!==ft||Ve.vertexTangents!==wt||Ve.morphTargets!==$e||Ve.morphNormals!==Et||Ve.morphColors!==jt||Ve.morphTargetsCount!==vi||Ve.numLightProbeGrids!==ci(A.state.lightProbeGridArray)?Rt=!0:(Ve.outputColorSpace!==Le||Ve.toneMapping!==Bt)&&(_r=!0):(Rt=!0,Ve.__version=Y.version);let pi=Ve.currentProgram;(Rt===!0||_r===!0)&&(pi=_r===!0?sn(Y,k,$,Le,Bt):ir(Y,k,$),z&&Y.isNodeMaterial&&z.onUpdateProgram(Y,pi,Ve));let ks=!1,nr=!1,vr=!1,St=pi.getUniforms(),ri=Ve.uniforms;if(Ee.useProgram(pi.program)&&(ks=!0,nr=!0,vr=!0),Y.id!==K&&(K=Y.id,nr=!0),ks||Q!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),St.setValue(U,"projectionMatrix",E.projectionMatrix),St.setValue(U,"viewMatrix",E.matrixWorldInverse);let di=St.map.cameraPosition;di!==void 0&&di.setValue(U,nt.setFromMatrixPosition(E.matrixWorld)),ht.logarithmicDepthBuffer&&St.setValue(U,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&St.setValue(U,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,nr=!0,vr=!0)}if(Ve.needsLights&&(fi.state.sunShadowMap.length>0&&St.setValue(U,"sunShadowMap",fi.state.sunShadowMap,it),fi.state.directionalShadowMap.length>0&&St.setValue(U,"directionalShadowMap",fi.state.directionalShadowMap,it),fi.state.spotShadowMap.length>0&&St.setValue(U,"spotShadowMap",fi.state.spotShadowMap,it),fi.state.pointShadowMap.length>0&&St.setValue(U,"pointShadowMap",fi.state.pointShadowMap,it)),$.isSkinnedMesh){St.setOptional(U,$,"bindMatrix"),St.setOptional(U,$,"bindMatrixInverse");let zt=$.skeleton;zt&&(zt.boneTexture===null&&zt.computeBoneTexture(),St.setValue(U,"boneTexture",zt.boneTexture,it))}$.isBatchedMesh&&(St.setOptional(U,$,"batchingTexture"),St.setValue(U,"batchingTexture",$._matricesTexture,it),St.setOptional(U,$,"batchingIdTexture"),St.setValue(U,"batchingIdTexture",$._indirectTexture,it),St.setOptional(U,$,"batchingColorTexture"),$._colorsTexture!==null&&St.setValue(U,"batchingColorTexture",$._colorsTexture,it));let $i=J.morphAttributes;if(($i.position!==void 0||$i.normal!==void 0||$i.color!==void 0)&&re.update($,J,pi),(nr||Ve.receiveShadow!==$.receiveShadow)&&(Ve.receiveShadow=$.receiveShadow,St.setValue(U,"receiveShadow",$.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(ri.envMapIntensity.value=k.environmentIntensity),ri.dfgLUT!==void 0&&(ri.dfgLUT.value=Z_()),nr){if(St.setValue(U,"toneMappingExposure",D.toneMappingExposure),Ve.needsLights&&Os(ri,vr),Pe&&Y.fog===!0&&be.refreshFogUniforms(ri,Pe),be.refreshMaterialUniforms(ri,Y,we,De,A.state.transmissionRenderTarget[E.id]),Ve.needsLights&&Ve.numLightProbeGrids>0){let zt=y,di=0;for(let Gi of A.state.lightProbeGridArray)Gi.texture!==null&&(zt.textures[di]=Gi.texture,zt.min[di]=Gi.boundingBox.min,zt.max[di]=Gi.boundingBox.max,zt.resolution[di]=Gi.resolution,di++);for(let Gi in zt)zt[Gi].length=di;ri.probesSH.value=zt.textures,ri.probesMin.value=zt.min,ri.probesMax.value=zt.max,ri.probesResolution.value=zt.resolution}ls.upload(U,Fr(Ve),ri,it)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ls.upload(U,Fr(Ve),ri,it),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&St.setValue(U,"center",$.center),St.setValue(U,"modelViewMatrix",$.modelViewMatrix),St.setValue(U,"normalMatrix",$.normalMatrix),St.setValue(U,"modelMatrix",$.matrixWorld),Y.uniformsGroups!==void 0){let zt=Y.uniformsGroups;for(let di=0,Gi=zt.length;di<Gi;di++){let Nl=zt[di];Qe.update(Nl,pi),Qe.bind(Nl,pi)}}return pi}function Os(E,k){E.ambientLightColor.needsUpdate=k,E.lightProbe.needsUpdate=k,E.sunLights.needsUpdate=k,E.sunLightShadows.needsUpdate=k,E.directionalLights.needsUpdate=k,E.directionalLightShadows.needsUpdate=k,E.pointLights.needsUpdate=k,E.pointLightShadows.needsUpdate=k,E.spotLights.needsUpdate=k,E.spotLightShadows.needsUpdate=k,E.rectAreaLights.needsUpdate=k,E.hemisphereLights.needsUpdate=k}function Ur(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(E,k,J){let Y=Ke.get(E);Y.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ke.get(E.texture).__webglTexture=k,Ke.get(E.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:J,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,k){let J=Ke.get(E);J.__webglFramebuffer=k,J.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(E,k=0,J=0){ce=E,q=k,G=J;let Y=null,$=!1,Pe=!1;if(E){let Le=Ke.get(E);if(Le.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(U.FRAMEBUFFER,Le.__webglFramebuffer),ee.copy(E.viewport),de.copy(E.scissor),ue=E.scissorTest,Ee.viewport(ee),Ee.scissor(de),Ee.setScissorTest(ue),K=-1;return}else if(Le.__webglFramebuffer===void 0)it.setupRenderTarget(E);else if(Le.__hasExternalTextures)it.rebindTextures(E,Ke.get(E.texture).__webglTexture,Ke.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ft=E.depthTexture;if(Le.__boundDepthTexture!==ft){if(ft!==null&&Ke.has(ft)&&(E.width!==ft.image.width||E.height!==ft.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");it.setupDepthRenderbuffer(E)}}let Oe=E.texture;(Oe.isData3DTexture||Oe.isDataArrayTexture||Oe.isCompressedArrayTexture)&&(Pe=!0);let Ze=Ke.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ze[k])?Y=Ze[k][J]:Y=Ze[k],$=!0):E.samples>0&&it.useMultisampledRTT(E)===!1?Y=Ke.get(E).__webglMultisampledFramebuffer:Array.isArray(Ze)?Y=Ze[J]:Y=Ze,ee.copy(E.viewport),de.copy(E.scissor),ue=E.scissorTest}else ee.copy(Je).multiplyScalar(we).floor(),de.copy(at).multiplyScalar(we).floor(),ue=rt;if(J!==0&&(Y=W),Ee.bindFramebuffer(U.FRAMEBUFFER,Y)&&Ee.drawBuffers(E,Y),Ee.viewport(ee),Ee.scissor(de),Ee.setScissorTest(ue),$){let Le=Ke.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+k,Le.__webglTexture,J)}else if(Pe){let Le=k;for(let Oe=0;Oe<E.textures.length;Oe++){let Ze=Ke.get(E.textures[Oe]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Oe,Ze.__webglTexture,J,Le)}}else if(E!==null&&J!==0){let Le=Ke.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Le.__webglTexture,J)}K=-1};function Bs(E){let k=Ke.get(E);return(k.__readFormat!==E.format||k.__readType!==E.type)&&(k.__readFormat=E.format,k.__readType=E.type,k.__formatReadable=ht.textureFormatReadable(E.format),k.__typeReadable=ht.textureTypeReadable(E.type)),k}this.readRenderTargetPixels=function(E,k,J,Y,$,Pe,Ue,Le=0){if(!(E&&E.isWebGLRenderTarget)){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=Ke.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ue!==void 0&&(Oe=Oe[Ue],Array.isArray(Oe)&&(Oe=Oe[0])),Oe){Ee.bindFramebuffer(U.FRAMEBUFFER,Oe);try{let Ze=E.textures[Le],ft=Ze.format,wt=Ze.type;E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Le);let $e=Bs(Ze);if($e.__formatReadable===!1){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($e.__typeReadable===!1){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=E.width-Y&&J>=0&&J<=E.height-$&&U.readPixels(k,J,Y,$,ye.convert(ft),ye.convert(wt),Pe)}finally{let Ze=ce!==null?Ke.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(U.FRAMEBUFFER,Ze)}}},this.readRenderTargetPixelsAsync=async function(E,k,J,Y,$,Pe,Ue,Le=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=Ke.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ue!==void 0&&(Oe=Oe[Ue],Array.isArray(Oe)&&(Oe=Oe[0])),Oe)if(k>=0&&k<=E.width-Y&&J>=0&&J<=E.height-$){Ee.bindFramebuffer(U.FRAMEBUFFER,Oe);let Ze=E.textures[Le],ft=Ze.format,wt=Ze.type;E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Le);let $e=Bs(Ze);if($e.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($e.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Et=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,Et),U.bufferData(U.PIXEL_PACK_BUFFER,Pe.byteLength,U.STREAM_READ),U.readPixels(k,J,Y,$,ye.convert(ft),ye.convert(wt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let jt=ce!==null?Ke.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(U.FRAMEBUFFER,jt);let Bt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Im(U,Bt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,Et),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Pe),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(Et),U.deleteSync(Bt),Pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,k=null,J=0){let Y=Math.pow(2,-J),$=Math.floor(E.image.width*Y),Pe=Math.floor(E.image.height*Y),Ue=k!==null?k.x:0,Le=k!==null?k.y:0;it.setTexture2D(E,0),U.copyTexSubImage2D(U.TEXTURE_2D,J,0,0,Ue,Le,$,Pe),Ee.unbindTexture()},this.copyTextureToTexture=function(E,k,J=null,Y=null,$=0,Pe=0){let Ue,Le,Oe,Ze,ft,wt,$e,Et,jt,Bt=E.isCompressedTexture?E.mipmaps[Pe]:E.image;if(J!==null)Ue=J.max.x-J.min.x,Le=J.max.y-J.min.y,Oe=J.isBox3?J.max.z-J.min.z:1,Ze=J.min.x,ft=J.min.y,wt=J.isBox3?J.min.z:0;else{let St=Math.pow(2,-$);Ue=Math.floor(Bt.width*St),Le=Math.floor(Bt.height*St),E.isDataArrayTexture?Oe=Bt.depth:E.isData3DTexture?Oe=Math.floor(Bt.depth*St):Oe=1,Ze=0,ft=0,wt=0}Y!==null?($e=Y.x,Et=Y.y,jt=Y.z):($e=0,Et=0,jt=0);let kt=ye.convert(k.format),vi=ye.convert(k.type),Ve;k.isData3DTexture?(it.setTexture3D(k,0),Ve=U.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(it.setTexture2DArray(k,0),Ve=U.TEXTURE_2D_ARRAY):(it.setTexture2D(k,0),Ve=U.TEXTURE_2D),Ee.activeTexture(U.TEXTURE0),Ee.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,k.flipY),Ee.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Ee.pixelStorei(U.UNPACK_ALIGNMENT,k.unpackAlignment);let fi=Ee.getParameter(U.UNPACK_ROW_LENGTH),Rt=Ee.getParameter(U.UNPACK_IMAGE_HEIGHT),_r=Ee.getParameter(U.UNPACK_SKIP_PIXELS),pi=Ee.getParameter(U.UNPACK_SKIP_ROWS),ks=Ee.getParameter(U.UNPACK_SKIP_IMAGES);Ee.pixelStorei(U.UNPACK_ROW_LENGTH,Bt.width),Ee.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Bt.height),Ee.pixelStorei(U.UNPACK_SKIP_PIXELS,Ze),Ee.pixelStorei(U.UNPACK_SKIP_ROWS,ft),Ee.pixelStorei(U.UNPACK_SKIP_IMAGES,wt);let nr=E.isDataArrayTexture||E.isData3DTexture,vr=k.isDataArrayTexture||k.isData3DTexture;if(E.isDepthTexture){let St=Ke.get(E),ri=Ke.get(k),$i=Ke.get(St.__renderTarget),zt=Ke.get(ri.__renderTarget);Ee.bindFramebuffer(U.READ_FRAMEBUFFER,$i.__webglFramebuffer),Ee.bindFramebuffer(U.DRAW_FRAMEBUFFER,zt.__webglFramebuffer);for(let di=0;di<Oe;di++)nr&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ke.get(E).__webglTexture,$,wt+di),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ke.get(k).__webglTexture,Pe,jt+di)),U.blitFramebuffer(Ze,ft,Ze+Ue,ft+Le,$e,Et,$e+Ue,Et+Le,U.DEPTH_BUFFER_BIT,U.NEAREST);Ee.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if($!==0||E.isRenderTargetTexture||Ke.has(E)){let St=Ke.get(E),ri=Ke.get(k);Ee.bindFramebuffer(U.READ_FRAMEBUFFER,I),Ee.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let $i=0;$i<Oe;$i++)nr?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,St.__webglTexture,$,wt+$i):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,St.__webglTexture,$),vr?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ri.__webglTexture,Pe,jt+$i):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ri.__webglTexture,Pe),$!==0?U.blitFramebuffer(Ze,ft,Ze+Ue,ft+Le,$e,Et,$e+Ue,Et+Le,U.COLOR_BUFFER_BIT,U.NEAREST):vr?U.copyTexSubImage3D(Ve,Pe,$e,Et,jt+$i,Ze,ft,Ue,Le):U.copyTexSubImage2D(Ve,Pe,$e,Et,Ze,ft,Ue,Le);Ee.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else vr?E.isDataTexture||E.isData3DTexture?U.texSubImage3D(Ve,Pe,$e,Et,jt,Ue,Le,Oe,kt,vi,Bt.data):k.isCompressedArrayTexture?U.compressedTexSubImage3D(Ve,Pe,$e,Et,jt,Ue,Le,Oe,kt,Bt.data):U.texSubImage3D(Ve,Pe,$e,Et,jt,Ue,Le,Oe,kt,vi,Bt):E.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Pe,$e,Et,Ue,Le,kt,vi,Bt.data):E.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Pe,$e,Et,Bt.width,Bt.height,kt,Bt.data):U.texSubImage2D(U.TEXTURE_2D,Pe,$e,Et,Ue,Le,kt,vi,Bt);Ee.pixelStorei(U.UNPACK_ROW_LENGTH,fi),Ee.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Rt),Ee.pixelStorei(U.UNPACK_SKIP_PIXELS,_r),Ee.pixelStorei(U.UNPACK_SKIP_ROWS,pi),Ee.pixelStorei(U.UNPACK_SKIP_IMAGES,ks),Pe===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&U.generateMipmap(Ve),Ee.unbindTexture()},this.initRenderTarget=function(E){Ke.get(E).__webglFramebuffer===void 0&&it.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?it.setTextureCube(E,0):E.isData3DTexture?it.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?it.setTexture2DArray(E,0):it.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){q=0,G=0,ce=null,Ee.reset(),Re.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var J_="#f4efe2";function Q_(n){let e=document.createElement("canvas");e.width=512,e.height=256;let t=e.getContext("2d");if(!t)return e;if(t.fillStyle=n.striped?J_:n.colour,t.fillRect(0,0,512,256),n.striped&&(t.fillStyle=n.colour,t.fillRect(0,256*(.5-.2),512,2*.2*256)),n.spotted&&Uw(t,"#c4202b"),n.label)for(let i of[.25,.75])Fw(t,i*512,256/2,n.label);return e}function Fw(n,e,t,i){n.fillStyle=J_,n.beginPath(),n.arc(e,t,.155*256,0,2*Math.PI),n.fill();let r=i.length>2?30:i.length>1?46:56;n.fillStyle="#16181a",n.font=`700 ${r}px "Helvetica Neue", Arial, "Liberation Sans", sans-serif`,n.textAlign="center",n.textBaseline="middle",n.fillText(i,e,t+.04*r,2*.155*256*.82),/^[69]$/.test(i)&&n.fillRect(e-.3*r,t+.44*r,.6*r,3)}function Uw(n,e){n.fillStyle=e;for(let i of[0,.25,.5,.75,1])n.beginPath(),n.arc(i*512,256/2,12.8,0,2*Math.PI),n.fill();n.fillRect(0,0,512,12.8),n.fillRect(0,256-12.8,512,12.8)}var Nw=`
varying vec3 polishNormal;
varying vec3 polishAt;
void main() {`,Ow=`
  vec4 polishPlace = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
    polishPlace = instanceMatrix * polishPlace;
  #endif
  polishAt = (modelMatrix * polishPlace).xyz;
  polishNormal = inverseTransformDirection(transformedNormal, viewMatrix);
}`;function Bw(n,e){let{cloth:t,floor:i}=n,[r,s]=[(t.x0+t.x1)/2,(t.y0+t.y1)/2],[o,a]=[t.x1-t.x0,t.y1-t.y0],l=Math.max(o,a),c=h=>h.toFixed(5),u=a>=o?[.12,.5]:[.5,.12];return`
varying vec3 polishNormal;
varying vec3 polishAt;
vec3 polishRoom(vec3 at, vec3 ray) {
  vec3 seen = mix(vec3(0.04, 0.07, 0.055), vec3(0.34, 0.33, 0.31), smoothstep(-0.15, 0.5, ray.z));
  if (ray.z > 0.02) {
    vec2 hit = (at.xy - vec2(${c(r)}, ${c(s)}) + ray.xy * (${c(.55*l+i)} - at.z) / ray.z) / ${c(l)};
    vec2 off = abs(hit) - vec2(${c(u[0])}, ${c(u[1])});
    seen += 13.0 * smoothstep(${c(e)}, ${c(-e)}, max(off.x, off.y)) * vec3(1.0, 0.95, 0.86);
  }
  return seen;
}`}function zu(n,e,t,i){let r=n.onBeforeCompile.bind(n);n.onBeforeCompile=(s,o)=>{r(s,o),s.vertexShader=s.vertexShader.replace("void main() {",Nw).replace(/\}\s*$/,Ow),s.fragmentShader=s.fragmentShader.replace("void main() {",`${Bw(e,i)}
void main() {`).replace("#include <opaque_fragment>",`vec3 polishFrom = normalize(polishAt - cameraPosition);
       vec3 polishUp = normalize(polishNormal);
       float polishMirror = 0.04 + 0.96 * pow(1.0 - clamp(dot(-polishFrom, polishUp), 0.0, 1.0), 5.0);
       outgoingLight += ${t.toFixed(3)} * polishMirror * polishRoom(polishAt, reflect(polishFrom, polishUp));
       #include <opaque_fragment>`)},n.customProgramCacheKey=()=>`polish ${t} ${i}`}function j_(n){let e=n>>>0;return()=>(e=Math.imul(e,1664525)+1013904223>>>0,e/4294967296)}function Df(n,e){let t=document.createElement("canvas");return t.width=n,t.height=e,[t,t.getContext("2d")]}function ev(n){let e=new is(n);return e.wrapS=Kr,e.wrapT=Kr,e.colorSpace=wi,e.anisotropy=8,e}function tv(){let[n,e]=[1024,128],[t,i]=Df(n,e);if(i){let r=j_(7);i.fillStyle="#6b3a20",i.fillRect(0,0,n,e);for(let s=0;s<420;s+=1){let o=r()*e,a=r()<.6;i.strokeStyle=a?`rgba(28,10,4,${.05+.16*r()})`:`rgba(190,110,60,${.03+.1*r()})`,i.lineWidth=.5+1.6*r();let[l,c,u]=[1+3*r(),1+Math.floor(2*r()),6.3*r()];i.beginPath();for(let h=0;h<=n;h+=16)i.lineTo(h,o+l*Math.sin(u+c*2*Math.PI*h/n));i.stroke()}}return ev(t)}function iv(){let[e,t]=Df(256,256);if(t){let i=j_(11);t.fillStyle="#e9e9e9",t.fillRect(0,0,256,256);for(let r=0;r<9e3;r+=1){let s=i()<.5?0:255;t.fillStyle=`rgba(${s},${s},${s},${.05*i()+.01})`,t.fillRect(i()*256,i()*256,1+2*i(),1)}}return ev(e)}function nv(){let[e,t]=Df(64,64);if(t){let i=t.createRadialGradient(32,32,0,32,32,32);i.addColorStop(0,"rgba(0,0,0,0.75)"),i.addColorStop(.45,"rgba(0,0,0,0.5)"),i.addColorStop(1,"rgba(0,0,0,0)"),t.fillStyle=i,t.fillRect(0,0,64,64)}return new is(e)}var Ff=64,kw=.12,[cs,zw,If,Pl]=[new O,new O,new Ii,new st],sv=new st().makeScale(0,0,0),Gu=class{constructor(e){this.stage=e;let{balls:t}=e.data,i=t.length>Ff,r=i?new Jo(1,20,14):new Jo(1,48,32);i?(this.instances=new Jn(r,rv(e,{}),t.length),t.forEach((o,a)=>this.instances?.setColorAt(a,new tt(zr(o.id,a).colour))),this.instances.castShadow=!0,this.instances.frustumCulled=!1,this.group.add(this.instances)):t.forEach((o,a)=>{let l=new is(Q_(zr(o.id,a)));l.colorSpace=wi,l.anisotropy=8;let c=new At(r,rv(e,{map:l}));c.castShadow=!0,c.receiveShadow=!0,this.meshes.push(c),this.group.add(c)});let s=new Un({map:nv(),transparent:!0,depthWrite:!1,opacity:.8});this.shades=new Jn(new Nn(2.5,2.5),s,t.length),this.shades.frustumCulled=!1,this.shades.renderOrder=1,this.group.add(this.shades)}stage;group=new rn;meshes=[];instances=null;shades;show(e,t,i,r){let{stage:s,meshes:o,instances:a,shades:l}=this,{positions:c,orientations:u,present:h,run:f}=e;s.radii.forEach((p,m)=>{cs.fromArray(c,3*m);let M=h[m]?0:(i-f.leaves[m])/(kw*r),d=M>=0&&M<1;cs.z-=2.2*p*Math.max(0,M)**2,If.fromArray(u,4*m).multiply(t),Pl.compose(cs,If,zw.setScalar(d?p:0)),a?a.setMatrixAt(m,Pl):(o[m].visible=d,o[m].position.copy(cs),o[m].quaternion.copy(If),o[m].scale.setScalar(p)),h[m]&&Pl.makeScale(p,p,p).setPosition(cs.x,cs.y,s.floor+.02),l.setMatrixAt(m,h[m]?Pl:sv)}),l.instanceMatrix.needsUpdate=!0,a&&(a.instanceMatrix.needsUpdate=!0)}};function rv(n,e){let t=new bn(e);return zu(t,n,1,.012),t}var Gw=`
attribute float seen;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec4 at = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  normalSeen = normalize(mat3(modelViewMatrix) * mat3(instanceMatrix) * normal);
  toEye = normalize(-at.xyz);
  amount = seen;
  gl_Position = projectionMatrix * at;
}`,Hw=`
uniform vec3 colour;
uniform float beats;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec3 n = normalize(normalSeen);
  float facing = clamp(dot(n, normalize(toEye)), 0.0, 1.0);
  float rim = smoothstep(0.62, 0.42, facing);
  float beat = beats < 0.5 ? 1.0 : smoothstep(0.22, 0.3, abs(fract(atan(n.y, n.x) / 6.2831853 * beats) - 0.5));
  float alpha = amount * max(0.3, rim * mix(0.35, 1.0, beat));
  gl_FragColor = vec4(mix(colour, vec3(1.0), 0.15 * facing), alpha);
  #include <colorspace_fragment>
}`,Hu=class{constructor(e,t){this.stage=e;let i=e.data.balls.length,{cloth:r,beats:s}=cn(t),o=new hi({vertexShader:Gw,fragmentShader:Hw,uniforms:{colour:{value:new tt(r)},beats:{value:s}},transparent:!0,depthWrite:!1}),a=new Jo(1,i>Ff?18:36,i>Ff?12:24);this.seen=new fr(new Float32Array(i),1),this.seen.setUsage(Rm),a.setAttribute("seen",this.seen),this.mesh=new Jn(a,o,i),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}stage;mesh;seen;show(e,t){let{mesh:i,seen:r,stage:s}=this;s.radii.forEach((o,a)=>{let[l,c]=[e.present[a]===1,t.present[a]===1],u=l?c?Yl(e.positions,t.positions,a):1:0;r.array[a]=u,cs.fromArray(e.positions,3*a),i.setMatrixAt(a,u>0?Pl.makeScale(1.02*o,1.02*o,1.02*o).setPosition(cs):sv)}),r.needsUpdate=!0,i.instanceMatrix.needsUpdate=!0}},Vu=class{constructor(e){this.stage=e;let t=new Un({color:"#ffe98a",transparent:!0,opacity:.95,depthTest:!1,depthWrite:!1}),i=new ss(1.02,1.2,64);this.called=Array.from({length:8},()=>new At(i,t)),this.chosen=new At(new ss(1.12,1.2,64),new Un({color:"#ffffff",transparent:!0,opacity:.7,depthWrite:!1})),this.called.forEach(r=>r.renderOrder=5),this.group.add(...this.called,this.chosen)}stage;group=new rn;called;chosen;show(e,t,i){this.called.forEach((r,s)=>this.put(r,e,t[s]??-1)),this.put(this.chosen,e,i)}put(e,t,i){if(e.visible=i>=0&&t.present[i]===1,e.visible){let r=this.stage.radii[i];e.scale.setScalar(r),e.position.set(t.positions[3*i],t.positions[3*i+1],this.stage.floor+.03)}}};var ov=26,Vw=.92,Ww=1.5,Xw=420,Wu=class{constructor(e,t,i){this.sight=e;this.floor=t;this.still=i}sight;floor;still;pose={tilt:0,turn:0,zoom:1,x:0,y:0};from=null;goal=null;began=0;lying=!0;look(e){this.to({tilt:e==="above"?0:Vw,turn:e==="above"?0:-.2,zoom:1,x:0,y:0})}close(e){let{tilt:t,turn:i}=this.goal??this.pose;this.to({tilt:t,turn:i,...e?Xl(this.sight,e):{zoom:1,x:0,y:0}})}orbit(e,t){let i=this.settle();i.turn+=e,i.tilt=Math.min(Ww,Math.max(0,i.tilt+t))}zoom(e){let t=this.settle();t.zoom=Math.min(2,Math.max(.04,t.zoom*e))}pan(e,t,i){let r=this.settle(),s=2*Math.tan(ov*Math.PI/360)*i.position.distanceTo(this.target(new O)),o=this.heading();r.x+=s*(e*Math.sin(o)+t*Math.cos(o)),r.y+=s*(-e*Math.cos(o)+t*Math.sin(o))}place(e,t){let i=this.ease(t),r=this.heading(),{tilt:s,zoom:o}=this.pose,a=new O(Math.cos(r),Math.sin(r),0),l=a.clone().multiplyScalar(-Math.sin(s));l.z=Math.cos(s);let c=a.clone().multiplyScalar(Math.cos(s));c.z=Math.sin(s);let u=new O(Math.sin(r),-Math.cos(r),0),h=this.target(new O),f=this.fit(e.aspect,u,c,l);return h.addScaledVector(c,f.rise*o),e.up.copy(c),e.position.copy(h).addScaledVector(l,f.distance*o),e.near=Math.max(.05,.02*f.distance*o),e.far=6*f.distance*Math.max(1,o)+50,e.lookAt(h),e.updateProjectionMatrix(),e.updateMatrixWorld(),i}heading(){return(this.lying?Math.PI:Math.PI/2)+this.pose.turn}target(e){let{sight:t,floor:i,pose:r}=this;return e.set((t.x0+t.x1)/2+r.x,(t.y0+t.y1)/2+r.y,i)}fit(e,t,i,r){let{sight:s}=this,[o,a]=[(s.x1-s.x0)/2,(s.y1-s.y0)/2],l=Math.tan(ov*Math.PI/360),c=l*e,h=[-1,1].flatMap(m=>[-1,1].flatMap(M=>[-2.6,2].map(d=>new O(m*o,M*a,d)))).map(m=>({x:m.dot(t),y:m.dot(i),z:m.dot(r)})),f=0,p=0;for(let m=0;m<6;m+=1){p=Math.max(...h.map(d=>d.z+Math.max(Math.abs(d.x)/c,Math.abs(d.y-f)/l)));let M=h.map(d=>(d.y-f)/(p-d.z));f+=(Math.max(...M)+Math.min(...M))/2*p*.8}return p=Math.max(...h.map(m=>m.z+Math.max(Math.abs(m.x)/c,Math.abs(m.y-f)/l))),{distance:p*1.04,rise:f}}to(e){if(this.still()){this.pose=e,this.goal=null;return}this.from={...this.pose},this.goal=e,this.began=performance.now()}settle(){return this.goal=null,this.pose}ease(e){let{from:t,goal:i}=this;if(!t||!i)return!1;let r=Math.min(1,Math.max(0,(e-this.began)/Xw)),s=r*r*(3-2*r),o=(a,l)=>a+s*(l-a);return this.pose={tilt:o(t.tilt,i.tilt),turn:o(t.turn,i.turn),zoom:o(t.zoom,i.zoom),x:o(t.x,i.x),y:o(t.y,i.y)},r>=1&&(this.goal=null),r<1}};var qw=.2,Yw=`
attribute float when;
attribute float way;
attribute vec3 tint;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  whenSeen = when;
  waySeen = way;
  tintSeen = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,$w=`
uniform float now;
uniform float fade;
uniform float dash;
uniform float strength;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  if (whenSeen > now || (dash > 0.0 && fract(waySeen / dash) > 0.6)) discard;
  float age = (now - whenSeen) / fade;
  gl_FragColor = vec4(tintSeen, strength * (0.3 + 0.7 * exp(-age)));
  #include <colorspace_fragment>
}`,Xu=class{mesh;material;constructor(e,t,i){let[r,s,o,a,l]=[[],[],[],[],[]],c=e.floor+(i?.016:.012);t.paths.forEach((f,p)=>{let m=i?new tt(cn(t.index).cloth):new tt(zr(e.data.balls[p].id,p).colour).lerp(new tt("#ffffff"),.25),M=zl(f,t.leaves[p]),d=0;for(let g=0;g+5<M.length;g+=3){let[v,T,y,C,A,x]=M.subarray(g,g+6),w=Math.hypot(A-T,x-y);if(w<1e-6)continue;let B=qw/2*(i?.8:1),[D,L]=[-(x-y)/w*B,(A-T)/w*B],z=r.length/3;r.push(T+D,y+L,c,T-D,y-L,c,A+D,x+L,c,A-D,x-L,c),s.push(v,v,C,C),o.push(d,d,d+w,d+w),a.push(...[0,1,2,3].flatMap(()=>[m.r,m.g,m.b])),l.push(z,z+1,z+2,z+2,z+1,z+3),d+=w}});let u=new Gt;u.setAttribute("position",new mt(r,3)),u.setAttribute("when",new mt(s,1)),u.setAttribute("way",new mt(o,1)),u.setAttribute("tint",new mt(a,3)),u.setIndex(l);let h=Math.max(1e-9,e.end/5);this.material=new hi({vertexShader:Yw,fragmentShader:$w,uniforms:{now:{value:0},fade:{value:h},dash:{value:i?1.4:0},strength:{value:i?.85:.8}},transparent:!0,depthWrite:!1,side:Si}),this.mesh=new At(u,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=2}show(e){this.material.uniforms.now.value=e}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}},Kw=`
attribute float when;
uniform float now;
uniform float life;
uniform float grows;
varying vec2 at;
varying float age;
void main() {
  age = (now - when) / life;
  at = position.xy;
  float size = age < 0.0 || age > 1.0 ? 0.0 : 1.0 + grows * 0.9 * age;
  gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position.xy * size, position.z, 1.0);
}`,Zw=`
varying vec2 at;
varying float age;
void main() {
  float d = length(at);
  float ring = smoothstep(0.7, 0.76, d) * smoothstep(1.0, 0.94, d);
  if (ring < 0.01) discard;
  gl_FragColor = vec4(1.0, 0.97, 0.85, ring * (1.0 - age) * 0.9);
}`,qu=class{mesh;material;constructor(e,t,i){let r=Gl(e,t);this.material=new hi({vertexShader:Kw,fragmentShader:Zw,uniforms:{now:{value:0},life:{value:pa},grows:{value:i?0:1}},transparent:!0,depthWrite:!1});let s=new Nn(2,2);s.setAttribute("when",new fr(Float32Array.from(r,o=>o.at),1)),this.mesh=new Jn(s,this.material,Math.max(1,r.length)),this.mesh.count=r.length,this.mesh.frustumCulled=!1,this.mesh.renderOrder=3,r.forEach((o,a)=>this.mesh.setMatrixAt(a,new st().makeScale(o.r,o.r,1).setPosition(o.x,o.y,e.floor+.025)))}show(e,t){this.material.uniforms.now.value=e,this.material.uniforms.life.value=pa*t}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}};var Jw="#0f6048",av=1.28,ra=1.62,Qw=.3,jw=.45;function lv(n){let e=new rn;e.position.z=n.floor,e.add(eE(n)),n.table&&e.add(iE(n.table,n),rE(n.table,n),oE(n.table,n));for(let t of n.pockets)e.add(...aE(t.x,t.y,t.r));return e}function eE(n){let e=n.table?Qi(n.cloth,1.25+.5*2.9):n.cloth,t=new pr([new le(e.x0,e.y0),new le(e.x1,e.y0),new le(e.x1,e.y1),new le(e.x0,e.y1)]),i=(a,l,c)=>a-c>e.x0&&a+c<e.x1&&l-c>e.y0&&l+c<e.y1;for(let{x:a,y:l,r:c}of n.pockets.filter(u=>i(u.x,u.y,u.r)))t.holes.push(new Dr().absarc(a,l,c,0,2*Math.PI,!0));let r=iv();r.repeat.set(1/9,1/9);let s=new bn({color:Hl,map:r});tE(s,n.cloth);let o=new At(new Su(t,40),s);return o.receiveShadow=!0,o}function tE(n,e){let t=(s,o)=>`vec2(${s.toFixed(5)}, ${o.toFixed(5)})`,i=t((e.x0+e.x1)/2,(e.y0+e.y1)/2),r=t((e.x1-e.x0)/2,(e.y1-e.y0)/2);n.onBeforeCompile=s=>{s.vertexShader=s.vertexShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
litAt = position.xy;`),s.fragmentShader=s.fragmentShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <map_fragment>",`#include <map_fragment>
       vec2 off = abs(litAt - ${i}) / ${r};
       diffuseColor.rgb *= mix(1.12, 0.66, smoothstep(0.25, 1.5, length(off)));`)}}function iE(n,e){let t=e.pockets.map(o=>({...o,r:o.r+Qw})),i=[];for(let o of $s(n,t).straights)nE(o,i);let r=new Gt;r.setAttribute("position",new mt(i,3)),r.computeVertexNormals();let s=new At(r,new bn({color:Jw,side:Si}));return s.castShadow=!0,s.receiveShadow=!0,s}function nE(n,e){let{x0:t,y0:i,x1:r,y1:s}=n,o=Math.hypot(r-t,s-i),[a,l]=[(r-t)/o,(s-i)/o],[c,u]=[l,-a],h=g=>(g?jw:1)*1.25,f=(g,v,T)=>[t+g*a+v*c,i+g*l+v*u,T],p=[[.22,0],[0,av-.2],[.1,av],[1.25,ra-.02],[1.25,0]],m=g=>-g/1.25*h(n.pocketBefore),M=g=>o+g/1.25*h(n.pocketAfter),d=(g,v,T,y)=>{e.push(...g,...v,...T,...g,...T,...y)};for(let g=0;g<3;g+=1){let[[v,T],[y,C]]=[p[g],p[g+1]];d(f(m(v),v,T),f(m(y),y,C),f(M(y),y,C),f(M(v),v,T))}for(let g of[m,M]){let[v,T,y,C,A]=p.map(([x,w])=>f(g(x),x,w));d(v,T,y,C),e.push(...v,...C,...A)}}function rE(n,e){let t=Qi(n,1.25+2.9),i=2.4,r=new pr;r.moveTo(t.x0+i,t.y0);for(let[u,h,f]of[[t.x1-i,t.y0+i,-.5],[t.x1-i,t.y1-i,0],[t.x0+i,t.y1-i,.5],[t.x0+i,t.y0+i,1]])r.absarc(u,h,i,f*Math.PI,(f+.5)*Math.PI,!1);let s=$s(Qi(n,1.25),cv(e)).points;r.holes.push(new Dr(s.map(([u,h])=>new le(u,h)).reverse()));let o=.22,a=new yu(r,{depth:ra+3-2*o,bevelSize:o,bevelThickness:o,bevelOffset:-o,bevelSegments:3,curveSegments:12});a.translate(0,0,-3+o);let l=new bn({map:tv()});sE(l,n),zu(l,e,.55,.12);let c=new At(a,l);return c.castShadow=!0,c.receiveShadow=!0,c}function sE(n,e){let t=[(e.x0+e.x1)/2,(e.y0+e.y1)/2],i=[(e.x1-e.x0)/2,(e.y1-e.y0)/2],r=s=>`vec2(${s.map(o=>o.toFixed(6)).join(",")})`;n.onBeforeCompile=s=>{s.vertexShader=s.vertexShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
grainAt = position;`),s.fragmentShader=s.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <map_fragment>",`vec2 far = abs(grainAt.xy - ${r(t)}) - ${r(i)};
       vec2 grainUv = far.x > far.y ? vec2(grainAt.y / 34.0, (grainAt.x + grainAt.z) / 7.0) : vec2(grainAt.x / 34.0 + 0.37, (grainAt.y + grainAt.z) / 7.0);
       diffuseColor *= texture2D(map, grainUv);`)}}function cv(n){return n.pockets.map(e=>({...e,r:e.r+.1}))}function oE(n,e){let t=Vl(n,e),i=new Jn(new xl(.26,4),new bn({color:"#efe6d2"}),Math.max(1,t.length));return i.count=t.length,t.forEach(([r,s],o)=>i.setMatrixAt(o,new st().makeTranslation(r,s,ra+.012))),i}function aE(n,e,t){let i=new At(new _l(t,t*.92,2.6,40,1,!0).rotateX(Math.PI/2),new bn({color:"#15110e",side:Si}));i.position.set(n,e,-1.3);let r=new At(new xl(t,40),new Un({color:"#050505"}));r.position.set(n,e,-2.5);let s=new At(new ss(t*.985,t*1.06,48),new bn({color:"#0b0a09"}));return s.position.set(n,e,.012),[i,r,s]}function uv(n){let e=new rn;if(e.position.z=n.floor,!n.table)return e;let t=new bn({color:"#17130f",side:Si});for(let i of $s(Qi(n.table,1.25),cv(n)).arcs){let{x:r,y:s,r:o}=i.pocket,a=new At(new _l(.985*o,.985*o,ra+1,40,1,!0,0,i.sweep).rotateX(Math.PI/2),t);a.position.set(r,s,(ra-1)/2+.02),a.rotation.z=i.from+Math.PI/2;let l=new At(new ss(o-.02,o+.42,40,1,i.from,i.sweep),t);l.position.set(r,s,ra+.02),e.add(a,l)}return e}function hv(n){let e=Qi(n.cloth,.4),t=new At(new Nn(e.x1-e.x0,e.y1-e.y0),new Un({color:"#0a3a2c"}));return t.position.set((e.x0+e.x1)/2,(e.y0+e.y1)/2,n.floor-.05),t}var lE=2,cE=45,uE=2e3,Uf=12,hE=.75,Ll=class{constructor(e,t,i){this.stage=e;this.still=t;this.canvas=document.createElement("canvas");let r=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!r)throw new Error("this browser has no WebGL 2");this.renderer=new Cl({canvas:this.canvas,context:r}),this.canvas.addEventListener("webglcontextlost",a=>{a.preventDefault(),i()});let{renderer:s,scene:o}=this;s.setClearColor(0,0),s.toneMapping=uo,s.toneMappingExposure=.95,s.shadowMap.enabled=!0,s.autoClear=!1,o.add(new bl("#fff6e8","#3a8a6a",1.75)),this.lamp(),o.add(lv(e),uv(e)),e.table||o.add(hv(e)),this.solid=new Gu(e),this.halos=new Vu(e),o.add(this.solid.group,this.halos.group);for(let a of e.runs){let l=new Hu(e,a.index);this.ghostBalls.push(l),o.add(l.mesh)}this.eye=new Wu(e.sight,e.floor,t)}stage;still;canvas;renderer;scene=new hl;camera=new Ui(26,1);eye;solid;halos;ghostBalls=[];trails=new Map;rings=new Map;base=new Ii;light=new wl("#fff1dc",2.7);width=1;height=1;slow=0;last=0;drawn=null;look(e){this.eye.look(e.camera==="free"?"free":"above")}close(e){this.eye.close(e)}orbit(e,t){this.eye.orbit(-3*e,-2.4*t)}zoom(e){this.eye.zoom(e)}pan(e,t){this.eye.pan(e,t,this.camera)}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t);let i=window.devicePixelRatio||1;this.renderer.setPixelRatio(this.slow>=Uf?hE*Math.min(1,i):Math.min(lE,i)),this.renderer.setSize(this.width,this.height,!1)}draw(e,t,i,r){let{renderer:s,camera:o,eye:a}=this,l=performance.now();this.watch(l,r),this.drawn={frame:e,choice:t},s.setScissorTest(!1),s.clear(),s.setScissorTest(!0);let c=!1,u=Gr(t),h=this.cells(u.length);return u.forEach((f,p)=>{let{x:m,y:M,width:d,height:g}=h[p];o.aspect=d/g,c=a.place(o,l)||c,this.arrange(e,t,f,i);let v=this.height-M-g;s.setViewport(m,v,d,g),s.setScissor(m,v,d,g),s.render(this.scene,o)}),c}pick(e,t){if(!this.drawn)return-1;let{frame:i,choice:r}=this.drawn,s=Gr(r),o=this.cells(s.length),a=ql(o,e,t);if(a<0)return-1;let{x:l,y:c,width:u,height:h}=o[a];this.camera.aspect=u/h,this.eye.place(this.camera,performance.now());let f=i.scatters[s[a]],p=new O,m={ball:-1,distance:18};for(let M=0;M<f.present.length;M+=1){p.fromArray(f.positions,3*M).project(this.camera);let d=Math.hypot(l+(p.x+1)/2*u-e,c+(1-p.y)/2*h-t);f.present[M]&&d<m.distance&&(m={ball:M,distance:d})}return m.ball}dispose(){this.scene.traverse(e=>{if(e instanceof At){let t=e;t.geometry.dispose();for(let i of[t.material].flat())i.map?.dispose(),i.dispose()}}),this.renderer.dispose(),this.canvas.remove()}arrange(e,t,i,r){let s=e.scatters[i];this.solid.show(s,this.base,e.time,r),this.halos.show(s,t.called,t.ball);let o=Wl(t,i);this.ghostBalls.forEach((a,l)=>{a.mesh.visible=o.includes(l),a.mesh.visible&&a.show(e.scatters[l],s)});for(let a of this.trails.values())a.mesh.visible=!1;if(t.trails)for(let a of[i,...o]){let l=this.trailsOf(a,a!==i);l.mesh.visible=!0,l.show(e.time)}for(let a of this.rings.values())a.mesh.visible=!1;if(t.marks){let a=this.ringsOf(i);a.mesh.visible=!0,a.show(e.time,r)}}trailsOf(e,t){let i=`${e} ${t}`,r=this.trails.get(i);return r||(r=new Xu(this.stage,this.stage.runs[e],t),this.trails.set(i,r),this.scene.add(r.mesh)),r}ringsOf(e){let t=this.rings.get(e);return t||(t=new qu(this.stage,this.stage.runs[e],this.still()),this.rings.set(e,t),this.scene.add(t.mesh)),t}cells(e){let{cells:t,lying:i}=ps(this.stage.sight,e,this.width,this.height);return this.lie(i),t}lie(e){this.eye.lying=e;let t=.3;e?this.base.setFromAxisAngle(new O(0,1,0),t).multiply(new Ii().setFromAxisAngle(new O(0,0,1),Math.PI/2)):this.base.setFromAxisAngle(new O(1,0,0),t)}lamp(){let{light:e,scene:t,stage:i}=this,{cloth:r}=i,[s,o]=[(r.x0+r.x1)/2,(r.y0+r.y1)/2],a=Math.hypot(r.x1-r.x0,r.y1-r.y0)/2+6;e.position.set(s-.25*a,o-.3*a,i.floor+1.6*a),e.target.position.set(s,o,i.floor),e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.radius=3,e.shadow.bias=-4e-4,e.shadow.normalBias=.04;let l=e.shadow.camera;[l.left,l.right,l.bottom,l.top]=[-a,a,-a,a],l.near=.2*a,l.far=3.2*a,t.add(e,e.target)}watch(e,t){let i=e-this.last;this.last=e,!(!t||i>uE||this.slow>=Uf)&&(this.slow=i>cE?this.slow+1:Math.max(0,this.slow-1),this.slow>=Uf&&(this.light.castShadow=!1,this.resize(this.width,this.height)))}};var fE=9;function fv(n,e,t={}){let i=new $l(Math.max(0,...e.runs.map(l=>l.end))),r=he("section",{class:"rp","aria-label":`Replay of ${e.scene.title}`},he("p",{class:"rp-wait"},"Unpacking the replay …"));n.append(r),n.classList.add("rp-live");let s=null,o=!1,a=fp(e).then(l=>{o||(s=new Nf(r,op(e,l),i,t))}).catch(l=>{throw r.replaceChildren(he("p",{class:"rp-wait",role:"alert"},`This replay cannot be shown: ${l instanceof Error?l.message:String(l)}`)),n.classList.remove("rp-live"),l});return a.catch(()=>{}),{ready:a,seek:l=>i.seek(l),play:()=>i.play(),pause:()=>i.pause(),time:()=>i.time,destroy:()=>{o=!0,i.stop(),s?.destroy(),r.remove(),n.classList.remove("rp-live")}}}var Nf=class{constructor(e,t,i,r){this.element=e;this.stage=t;this.clock=i;let{data:s,runs:o}=t;this.frame=new jl(t);let a=Math.max(0,s.runs.findIndex(u=>u.reference)),l=s.balls.findIndex(u=>u.id==="cue");this.choice={camera:"above",solid:a,shown:o.map(()=>!0),apart:!1,trails:!0,marks:!0,ball:Math.max(0,l),called:[]},this.view=r.flat?null:this.world(),this.solidView=this.view!==null,this.view??=new Hr(t,this.still),this.solidView||(this.choice.camera="flat"),this.controls=new Ql(t,i,this,this.solidView),this.legend=new tc(t,this),this.readout=new _c(t),this.plots=new xc(t,this,r.growing??!1);let c=mp();this.picture.setAttribute("aria-label",`The table of ${s.scene.title}; the same in numbers under “Where the balls are now”`),this.picture.append(this.view.canvas,this.captions),e.replaceChildren(this.picture,this.controls.element,this.banner,this.status,this.legend.element,this.plots.element,this.readout.element,c),dp(this.picture,{view:()=>this.view,again:this.ask,choose:u=>this.follow(u)}),gp(e,{actions:this,view:()=>this.view,end:()=>t.end,camera:()=>this.choice.camera,nextCamera:()=>this.nextCamera(),toggleTrails:()=>this.trails(!this.choice.trails),again:this.ask,keys:c}),this.sizes=new ResizeObserver(()=>this.resize()),this.sizes.observe(e),i.listen(this.tick),this.resize(),this.view.look(this.choice),this.changed(),this.controls.mark(this.events()),this.tick(),r.autoplay&&!this.calm.matches&&i.play()}element;stage;clock;frame;choice;controls;legend;readout;plots;picture=he("div",{class:"rp-picture",tabindex:0,role:"group"});captions=he("div",{class:"rp-captions"});banner=he("p",{class:"rp-banner",hidden:!0});status=he("p",{class:"rp-status",role:"status"});sizes;calm=matchMedia("(prefers-reduced-motion: reduce)");view=null;waiting=null;called=-1;asked=0;solidView=!0;destroy(){cancelAnimationFrame(this.asked),this.sizes.disconnect(),this.plots.destroy(),this.view?.dispose(),this.waiting?.dispose(),this.view=null}toggle(){this.clock.playing?(this.clock.pause(),this.speak(this.where())):(this.clock.play(),this.speak("plays"))}seek(e){this.call(-1),this.clock.seek(e)}nudge(e){this.seek(this.clock.time+e*this.stage.end),this.clock.playing||this.speak(this.where())}event(e){this.clock.pause(),this.call(-1);let t=this.events(),i=ma(t,this.clock.time);if(e===1)this.clock.seek(i<t.length?t[i].at:this.stage.end);else{let r=i-1;for(;r>=0&&t[r].at>=this.clock.time;)r-=1;this.clock.seek(r>=0?t[r].at:0)}this.speak(this.where())}parting(e){let{partings:t,balls:i}=this.stage.data;if(t.length===0){this.speak("no collision order differs");return}this.clock.pause();let r=e??(this.called+1)%t.length,s=t[r];for(let o of s.runs)o<this.choice.shown.length&&(this.choice.shown[o]=!0);this.clock.seek(Math.fround(s.time)),this.call(r),this.choice.called=s.balls.map(o=>i.findIndex(a=>a.id===o)).filter(o=>o>=0),this.view?.close(this.around(this.choice.called)),this.changed(),this.speak(`${Oi(s.time,this.stage.end)} ${this.stage.data.scene.time_unit}: ${s.words}`)}rate(e){this.clock.rate=e}faster(e){let t=Ys.indexOf(this.clock.rate)+e;this.rate(Ys[Math.min(Ys.length-1,Math.max(0,t))]),this.speak(`speed ${this.clock.rate}`)}look(e){this.waiting?.dispose(),this.waiting=null;let t=e==="flat";t!==(this.choice.camera==="flat")&&this.swap(t?new Hr(this.stage,this.still):this.world()),this.choice.camera=this.view instanceof Hr?"flat":e,this.view?.look(this.choice),this.changed()}apart(e){this.choice.apart=e,this.changed()}trails(e){this.choice.trails=e,this.changed()}marks(e){this.choice.marks=e,this.changed()}show(e,t){this.choice.shown[e]=t,this.changed()}solid(e){this.choice.shown[e]=!0,this.choice.solid=e,this.controls.mark(this.events()),this.changed(),this.tick()}follow(e){this.choice.ball=e,this.changed()}nextCamera(){let e=this.solidView?["above","free","flat"]:["flat"];this.look(e[(e.indexOf(this.choice.camera)+1)%e.length])}still=()=>this.calm.matches;world(){try{return new Ll(this.stage,this.still,()=>this.lost())}catch{return null}}lost(){let e=this.view;if(!(e instanceof Ll))return;let{camera:t}=this.choice;e.canvas.addEventListener("webglcontextrestored",()=>{this.view instanceof Hr&&this.waiting===e&&(this.waiting=null,this.choice.camera=t,this.swap(e),this.changed())},{once:!0}),this.waiting=e,this.choice.camera="flat",this.swap(new Hr(this.stage,this.still)),this.changed(),this.speak("the graphics were lost: the table is drawn flat")}swap(e){if(!e||!this.view)return;let t=this.view;t.canvas.replaceWith(e.canvas),t!==this.waiting&&t.dispose(),this.view=e,this.resize()}events(){return this.stage.runs[this.choice.solid]?.events??[]}where(){let{clock:e,stage:t}=this,i=this.events(),r=ma(i,e.time),s=[];for(let a=r-1;a>=0&&i[a].at===e.time;a-=1)s.unshift(Jl(i[a]));let o=`${Oi(e.time,t.end)} ${t.data.scene.time_unit}`;return s.length>0?`${o}, event ${r} of ${i.length}: ${s.join("; ")}`:`${o}, ${r} of ${i.length} events`}speak(e){en(this.status,e)}call(e){this.called=e;let t=e>=0?this.stage.data.partings[e]:void 0;if(this.banner.hidden=t===void 0,t){let{data:i,end:r}=this.stage,s=t.runs.map(o=>he("span",{class:"rp-who"},Ks(o),i.runs[o]?.label??""));this.banner.replaceChildren(...s,he("b",{},`part at ${Oi(t.time,r)} ${i.scene.time_unit}. `),t.words)}else this.choice.called.length>0&&(this.choice.called=[],this.view?.close(null),this.ask());this.element.dataset.parting=String(e)}around(e){let{choice:t,frame:i}=this;i.go(this.clock.time);let r={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0};for(let s of i.scatters.filter(({run:o})=>t.shown[o.index]))for(let o of e){let[a,l]=[s.positions[3*o],s.positions[3*o+1]];r.x0=Math.min(r.x0,a),r.x1=Math.max(r.x1,a),r.y0=Math.min(r.y0,l),r.y1=Math.max(r.y1,l)}return r.x1>=r.x0&&r.y1>=r.y0?Qi(r,fE):null}tick=()=>{let{clock:e,element:t,stage:i}=this,r=this.called>=0?i.data.partings[this.called]:void 0;r&&Math.abs(e.time-r.time)>.8*e.rate*e.base&&this.call(-1),t.dataset.time=String(e.time),t.dataset.playing=String(e.playing),this.controls.tell(this.events()),this.plots.go(e.time,e.playing),this.ask(),!e.playing&&e.time>=i.end&&i.end>0&&this.speak(`the end, ${this.where()}`)};changed(){let{choice:e,stage:t}=this;this.controls.choose(e),this.legend.choose(e),this.plots.choose(e),this.element.dataset.view=e.camera,this.caption(),this.plots.go(this.clock.time,this.clock.playing),this.element.dataset.solid=t.data.runs[e.solid]?.label??"",this.ask()}caption(){let{choice:e,stage:t}=this,i=Gr(e);if(this.captions.hidden=i.length<2,i.length<2)return;let{width:r,height:s}=this.picture.getBoundingClientRect(),{cells:o}=ps(t.sight,i.length,r,s);this.captions.replaceChildren(...i.map((a,l)=>{let c=he("span",{},Ks(a),t.data.runs[a].label);return c.style.left=`${o[l].x}px`,c.style.top=`${o[l].y}px`,c}))}resize(){let{stage:e,picture:t,view:i}=this,r=this.element.clientWidth;if(r<=0||!i)return;let{sight:s}=e,o=[s.x1-s.x0,s.y1-s.y0],[a,l]=[Math.max(...o),Math.min(...o)],c=r<560,u=c?r*a/l:r*l/a,h=Math.round(Math.min(Math.max(u,260),Math.max(300,(c?.56:.64)*window.innerHeight)));t.style.height=`${h}px`,i.resize(r,h),this.caption(),this.draw()}ask=()=>{this.asked===0&&(this.element.dataset.pending="true",this.asked=requestAnimationFrame(()=>{this.asked=0,this.element.dataset.pending="false",this.draw()}))};draw(){this.view&&(this.frame.go(this.clock.time),this.readout.tell(this.frame,this.choice.solid,this.clock.playing),this.element.dataset.drawn=String(this.clock.time),this.view.draw(this.frame,this.choice,this.clock.rate*this.clock.base,this.clock.playing)&&this.ask())}};var Fl=class extends Error{constructor(t){super(t.map(i=>i.message).join("; "));this.problems=t}problems},pv=200*1024,pE=350;function er(n){let e=document.querySelector(n);if(!e)throw new Error(`the page has no ${n}`);return e}var Of=class{form=er("#shot");tools=er("#tools");status=er("#status");lead=er("#lead");stage=er("#replay");answer=er("#answer");name=er("#name");stop=Sr("Stop the computation",["Stop"],()=>this.running?.abort());copy=Sr("Copy a link that carries the whole scene",["Copy link"],()=>{this.copyLink()});save=Sr("Save as a scene file",["Save scene"],()=>this.saveFile());file=he("input",{type:"file",accept:".toml,text/plain",class:"sr",id:"open-file"});calm=matchMedia("(prefers-reduced-motion: reduce)");base="";link=null;running=null;drawing=null;pause=0;replay=null;constructor(){this.form.noValidate=!0,this.link=document.querySelector("#link")?.getAttribute("href")??null,this.stop.hidden=!0;let e=he("label",{class:"file",for:"open-file"},"Open scene …",this.file);this.tools.replaceChildren(this.copy,this.save,e),this.filledIn(),this.form.addEventListener("submit",t=>{t.preventDefault(),this.start(t.submitter)}),this.form.addEventListener("input",t=>this.typed(t.target)),er("#picker").addEventListener("submit",t=>{t.preventDefault();let i=er("#scene").value;this.load(()=>Il(`/scenes/${encodeURIComponent(i)}`))}),this.file.addEventListener("change",()=>{let[t]=this.file.files??[];t&&this.openFile(t),this.file.value=""}),this.dropping()}get text(){return er("#f-scene")}filledIn(){this.base=this.text.value,this.form.querySelector(".go")?.append(this.stop),this.linked()}linked(){this.copy.disabled=this.link===null,this.copy.title=this.link===null?"This scene is too long for a link: save it as a file":"Copy a link that carries the whole scene"}fields(e){let t={},i=new FormData(this.form);for(let r of new Set(i.keys())){let s=i.getAll(r).filter(a=>typeof a=="string"),o=r==="engine"||r==="more-engines"||r.startsWith("dt.");r==="engine"?t[r]=s:r!=="scene"&&r!=="run"&&(e==="form"||o)&&(t[r]=s[s.length-1]??"")}return{scene:e==="form"?this.base:this.text.value,fields:t}}unreadable(){return[...this.form.querySelectorAll("input[type=number]")].filter(t=>t.validity.badInput&&t.offsetParent!==null).map(t=>({field:t.name,line:null,column:null,message:`${t.labels?.[0]?.firstChild?.textContent?.trim()??t.name} must be a number`,help:"such as 0.2 or 1e-3"}))}async start(e){let t=e instanceof HTMLButtonElement&&e.value==="file",i=t?[]:this.unreadable();if(i.length>0){this.wrong(i);return}clearTimeout(this.pause),this.drawing?.abort(),this.running?.abort();let r=new AbortController;this.running=r,this.busy(!0);let s=performance.now();try{let o=this.fields(t?"file":"form");await Il("/scene",o,r.signal);let a=await Il("/shot",o,r.signal);this.shown(a,t,(performance.now()-s)/1e3)}catch(o){this.running===r&&this.failed(o,"The computation was stopped.")}finally{this.running===r&&(this.running=null,this.busy(!1))}}busy(e){this.form.querySelector(".start")?.setAttribute("aria-busy",String(e)),this.stop.hidden=!e,e&&this.say("Running …")}shown(e,t,i){this.correct(),t?this.fill(e):this.take(e);let r=e.notice?`<p class="notice-line">${dE(e.notice)}</p>`:"";this.answer.innerHTML=r+e.html,this.answer.append(he("p",{},"The same numbers on a command line, with the scene saved:"),he("pre",{},he("code",{},e.command))),this.replay?.destroy(),this.replay=null,this.stage.classList.remove("stale");let s=this.answer.querySelector(".lead");en(this.lead,s?.textContent??""),s?.remove(),this.say(`Answered in ${i.toFixed(2)} s. ${e.no_replay?`There is no replay: ${e.no_replay}.`:""}`),e.replay&&(this.replay=fv(this.stage,e.replay,{growing:!0,autoplay:!0})),this.stage.getBoundingClientRect().top>.7*window.innerHeight&&this.lead.scrollIntoView({behavior:this.calm.matches?"auto":"smooth",block:"start"})}take(e){this.text.value=e.toml,this.link=e.link,en(this.name,e.name),document.title=`${e.name} · carom play`,e.link&&history.replaceState(null,"",e.link),this.linked()}fill(e){let t=[...this.form.querySelectorAll("details[open]")].map(s=>s.id),i=document.activeElement?.id;this.form.innerHTML=e.form;for(let s of t)document.getElementById(s)?.setAttribute("open","");this.filledIn(),this.take(e);let r=er("#scene");[...r.options].some(s=>s.value===e.name)&&(r.value=e.name),i&&this.form.contains(document.getElementById(i))&&document.getElementById(i)?.focus({preventScroll:!0})}typed(e){clearTimeout(this.pause);let t=e===this.text;this.pause=window.setTimeout(()=>{this.draw(t)},pE)}async draw(e){let t=e?[]:this.unreadable();if(t.length>0){this.wrong(t,!1);return}this.drawing?.abort();let i=new AbortController;this.drawing=i;try{let r=await Il("/scene",this.fields(e?"file":"form"),i.signal);if(this.correct(),e){let{selectionStart:s,selectionEnd:o,scrollTop:a}=this.text,l=this.text.value;this.fill(r),this.text.value=l,this.base=l,this.text.setSelectionRange(s,o),this.text.scrollTop=a}else this.take(r);this.outdated(r)}catch(r){r instanceof Fl?this.wrong(r.problems,!1):i.signal.aborted||this.failed(r,"")}}outdated(e){this.replay?(this.stage.classList.add("stale"),this.answer.classList.add("stale"),this.say("The inputs have changed since this ran.")):(this.stage.innerHTML=e.picture,this.say(""))}async load(e){this.running?.abort();try{let t=await e();this.correct(),this.fill(t),this.replay?.destroy(),this.replay=null,this.answer.replaceChildren(),this.lead.replaceChildren(),this.stage.classList.remove("stale"),this.stage.innerHTML=t.picture,this.say(`Opened ${t.name}.`)}catch(t){this.failed(t,"")}}async openFile(e){if(e.size>pv){this.wrong([{field:null,line:null,column:null,message:`${e.name} has ${e.size} bytes; ${pv} are the most`,help:"carom compare takes a file of any size"}]);return}let t=await e.text();await this.load(()=>Il("/scene",{scene:t}))}dropping(){let{body:e}=document,t=i=>i.dataTransfer?.types.includes("Files")??!1;addEventListener("dragover",i=>{t(i)&&(i.preventDefault(),e.classList.add("dropping"))}),addEventListener("dragleave",i=>{i.relatedTarget===null&&e.classList.remove("dropping")}),addEventListener("drop",i=>{e.classList.remove("dropping");let r=i.dataTransfer?.files[0];r&&(i.preventDefault(),this.openFile(r))})}async copyLink(){if(this.link===null)return;let e=location.origin+this.link;try{await navigator.clipboard.writeText(e),this.say("The link is copied. It works wherever carom play runs on this port.")}catch{history.replaceState(null,"",this.link),this.say("The browser does not let a page copy: the link is in its address bar.")}}saveFile(){let e=this.name.textContent||"scene",t=`data:application/toml;charset=utf-8,${encodeURIComponent(this.text.value)}`;he("a",{href:t,download:`${e}.toml`}).click(),this.say(`Saved as ${e}.toml.`)}failed(e,t){e instanceof Fl?this.wrong(e.problems):e instanceof DOMException&&e.name==="AbortError"?this.say(t):this.say("carom play does not answer: it may have been ended. Start it again with carom play.",!0)}correct(){this.form.querySelectorAll(".error").forEach(e=>e.remove()),this.form.querySelector(".errors")?.replaceChildren();for(let e of this.form.querySelectorAll("[aria-invalid]"))e.removeAttribute("aria-invalid"),e.setAttribute("aria-describedby",`hint-${e.id}`);this.stage.classList.remove("stale"),this.answer.classList.remove("stale"),this.status.classList.remove("wrong")}wrong(e,t=!0){this.correct();let i=this.form.querySelector(".errors"),r=null;for(let l of e){let c=l.field===null?null:this.control(l.field);if(!c){let p=l.line===null?"":`${l.line}:${l.column}: `;i?.append(he("li",{},p,...Dl(l.message),". ",he("span",{class:"help"},...Dl(l.help))));continue}let u=l.field==="scene"&&l.line!==null?`line ${l.line}: `:"",h=`error-${c.id}`,f=he("p",{class:"error"},u,...Dl(l.message),". ",he("span",{class:"help"},...Dl(l.help)));document.getElementById(h)||(f.id=h),c.setAttribute("aria-invalid","true"),c.setAttribute("aria-describedby",`${h} hint-${c.id}`),c.closest(".field, .tick")?.append(f),c.closest("details")?.setAttribute("open",""),r??=c}let s=r?.closest(".field")?.querySelector("label")?.textContent,o=e.length===1?"One thing is wrong":`${e.length} things are wrong`,[{message:a}]=e;this.say(`${o}. ${s&&r?.getAttribute("name")===e[0].field?`${s}: `:""}${a}.`,!0),t&&r?.focus()}control(e){return this.form.querySelectorAll(`[name="${CSS.escape(e)}"]:not([type=hidden])`)[0]??null}say(e,t=!1){this.status.replaceChildren(...Dl(e)),this.status.classList.toggle("wrong",t)}};function dE(n){return he("p",{},n).innerHTML}function Dl(n){return n.split("`").map((e,t)=>t%2===1?he("code",{},e):e)}async function Il(n,e,t){let i=e===void 0?{}:{method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e)},r=await fetch(n,{...i,signal:t??null}),s=await r.json();if(s.errors||!r.ok)throw new Fl(s.errors??[{field:null,line:null,column:null,message:`the server answered ${r.status}`,help:""}]);return s}new Of;})();

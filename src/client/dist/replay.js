/* carom. Contains three.js and uPlot, MIT; texts in src/client/LICENSES. */
"use strict";(()=>{var Sv=Object.defineProperty;var yv=(n,e)=>{for(var t in e)Sv(n,t,{get:e[t],enumerable:!0})};var Xs=[.05,.1,.25,.5,1,2,4,10];function Gn(){return{position:new Float64Array(3),velocity:new Float64Array(3),spin:new Float64Array(3)}}var Fl=class{constructor(e,t,i,r){this.times=e;this.positions=t;this.velocities=i;this.spins=r}times;positions;velocities;spins;hint=0;get count(){return this.times.length}knotsUntil(e,t=!1){let{times:i}=this,r=l=>t?i[l]<e:i[l]<=e,s=this.hint;if((s===0||r(s-1))&&(s===i.length||!r(s)))return s;if(s<i.length&&r(s)&&(s+1===i.length||!r(s+1)))return this.hint=s+1;let o=0,a=i.length;for(;o<a;)s=o+a>>1,r(s)?o=s+1:a=s;return this.hint=o}at(e,t,i=!1){let{times:r}=this;if(r.length===0)return!1;let s=this.knotsUntil(e,i);return i&&s<r.length&&r[s]===e?this.copy(s,t):s===0||s===r.length?this.copy(s===0?0:s-1,t):this.between(s-1,e,t),!0}copy(e,t){for(let i=0;i<3;i+=1)t.position[i]=this.positions[3*e+i],t.velocity[i]=this.velocities[3*e+i],t.spin[i]=this.spins.length>0?this.spins[3*e+i]:0}between(e,t,i){let{times:r,positions:s,velocities:o,spins:a}=this,l=r[e+1]-r[e],c=(t-r[e])/l,[u,h]=[c*c,c*c*c],[f,p]=[3*e,3*e+3];for(let m=0;m<3;m+=1)i.position[m]=s[f+m]*(2*h-3*u+1)+o[f+m]*(l*(h-2*u+c))+s[p+m]*(3*u-2*h)+o[p+m]*(l*(h-u)),i.velocity[m]=o[f+m]+c*(o[p+m]-o[f+m]),i.spin[m]=a.length>0?a[f+m]+c*(a[p+m]-a[f+m]):0}};var bv=.06,Ev=24;function Nl(n,e){let t=[],i=Gn(),{times:r,positions:s,velocities:o}=n;for(let a=0;a<n.count&&r[a]<=e;a+=1){let[l,c]=[s[3*a],s[3*a+1]],u=t.length-3;!(u>=0&&t[u+1]===l&&t[u+2]===c)||a+1===n.count?t.push(r[a],l,c):t[u]=r[a];let f=a+1<n.count?r[a+1]-r[a]:0;if(f>0){let p=wv(o,3*a,3*a+3),m=Math.min(Ev,Math.ceil(p/bv));for(let M=1;M<m;M+=1){let d=r[a]+f*M/m;n.at(d,i),t.push(d,i.position[0],i.position[1])}}}return Float64Array.from(t)}function wv(n,e,t){let i=n[e]*n[t+1]-n[e+1]*n[t],r=n[e]*n[t]+n[e+1]*n[t+1];return Math.abs(Math.atan2(i,r))}var ha=.45;function Ol(n,e){let t=new Map(n.data.balls.map((o,a)=>[o.id,a])),[i,r]=[Gn(),Gn()],s=[];for(let o of e.events){let a=t.get(o.a);if(a===void 0||!e.paths[a]?.at(o.at,i))continue;let[l,c,u]=[i.position[0],i.position[1],n.radii[a]],h=t.get(o.b);if(o.kind==="ball-ball"&&h!==void 0&&e.paths[h]?.at(o.at,r)){let f=u/(u+n.radii[h]);s.push({at:o.at,x:l+f*(r.position[0]-l),y:c+f*(r.position[1]-c),r:1.25*Math.max(u,n.radii[h])})}else if(o.kind==="ball-cushion"){let f={x0:[-u,0],x1:[u,0],y0:[0,-u],y1:[0,u]},[p,m]=f[o.b]??[0,0];s.push({at:o.at,x:l+p,y:c+m,r:.8*u})}else o.kind==="pocket"&&s.push({at:o.at,x:l,y:c,r:1.6*u})}return s}function qs(n,e){let t=e.every(l=>e.every(c=>l===c||Math.hypot(l.x-c.x,l.y-c.y)>l.r+c.r)),i=[[n.x0,n.y0],[n.x1,n.y0],[n.x1,n.y1],[n.x0,n.y1]],r=[],s=0,o=[];for(let l=0;l<4;l+=1){let[c,u]=i[l],[h,f]=i[(l+1)%4],p=Math.hypot(h-c,f-u),[m,M]=[(h-c)/p,(f-u)/p];o.push(s);for(let d of t?e:[]){let g=(d.x-c)*m+(d.y-u)*M,v=(d.x-c)*M-(d.y-u)*m;if(Math.abs(v)>=d.r)continue;let T=Math.sqrt(d.r*d.r-v*v);for(let S of[!0,!1]){let C=g+(S?-T:T);C>=0&&C<=p&&r.push({at:s+C,enters:S,pocket:d,x:c+C*m,y:u+C*M})}}s+=p}r.sort((l,c)=>l.at-c.at);let a=r.every((l,c)=>l.enters!==r[(c+1)%r.length].enters);return Tv(i,o,a&&r.length>1?r:[])}function Tv(n,e,t){let i={points:[],arcs:[],straights:[]},r=o=>({at:e[o],enters:!1,pocket:{x:0,y:0,r:0},x:n[o][0],y:n[o][1]});if(t.length===0){for(let o=0;o<4;o+=1)ju(i,r(o),r((o+1)%4),!1,!1);return i}let s=t.findIndex(o=>!o.enters);for(let o=0;o<t.length;o+=2){let a=t[(s+o)%t.length],l=t[(s+o+1)%t.length],c=e.map((d,g)=>({at:d,edge:g})).filter(({at:d})=>a.at<l.at?d>a.at&&d<l.at:d>a.at||d<l.at).sort((d,g)=>Qf(d.at,a.at)-Qf(g.at,a.at)),u=a,h=!0;for(let{edge:d}of c)ju(i,u,r(d),h,!1),u=r(d),h=!1;ju(i,u,l,h,!0);let f=t[(s+o+2)%t.length],{pocket:p}=l,m=Math.atan2(l.y-p.y,l.x-p.x),M=Math.atan2(f.y-p.y,f.x-p.x)-m;M+=M<=0?2*Math.PI:0,i.arcs.push({pocket:p,from:m,sweep:M});for(let d=0;d<28;d+=1){let g=m+M*d/28;i.points.push([p.x+p.r*Math.cos(g),p.y+p.r*Math.sin(g)])}}return i}function Qf(n,e){return n>e?n:n+1e12}function ju(n,e,t,i,r){n.points.push([e.x,e.y]),Math.hypot(t.x-e.x,t.y-e.y)>1e-9&&n.straights.push({x0:e.x,y0:e.y,x1:t.x,y1:t.y,pocketBefore:i,pocketAfter:r})}var Av=["#f2b705","#1747b0","#d3202a","#4b2a86","#f26a1b","#0b6b3a","#7d1a22","#16181a"],jf=["#c8452f","#2f6fb0","#e0a526","#3d8f63","#8a5aa8","#d9793a","#4aa0a8","#b0567c","#7a8a2e","#5a6b7a"],Rv="#f6f1e4";function Br(n,e){if(/^(cue|white)$/i.test(n))return{colour:Rv,striped:!1,label:"",spotted:!0};let t=/^\d{1,2}$/.test(n)?Number(n):0;if(t>=1&&t<=15)return{colour:Av[(t-1)%8],striped:t>8,label:String(t),spotted:!1};let i=[...n].length<=3?n:[...n].slice(0,3).join("");return{colour:jf[e%jf.length],striped:!1,label:i,spotted:!1}}var ep=[{light:"#0072b2",dark:"#4aa3e0",cloth:"#7cc8ff",dash:[],beats:0},{light:"#b84e00",dark:"#ff8a3c",cloth:"#ff9a4d",dash:[7,4],beats:8},{light:"#007a59",dark:"#2fc79a",cloth:"#9dffd8",dash:[2,3],beats:16},{light:"#a0437c",dark:"#e08ac0",cloth:"#ff9ddb",dash:[10,3,2,3],beats:5},{light:"#8a5f00",dark:"#edb93c",cloth:"#ffe066",dash:[14,5],beats:4},{light:"#1f7aa8",dark:"#9bd3f5",cloth:"#d5efff",dash:[5,2,1,2],beats:12},{light:"#1d2429",dark:"#e4e8eb",cloth:"#ffffff",dash:[1,2],beats:20}];function ln(n){return ep[n%ep.length]}function eh(n){return matchMedia("(prefers-color-scheme: dark)").matches?ln(n).dark:ln(n).light}var Bl="#12694f";function tp(n,e){let[t,i]=n.origin,r=(d,g)=>[(d-t)/n.R,(g-i)/n.R],s=Float64Array.from(n.balls,d=>d.radius/n.R),o=n.pockets.map(([d,g,v])=>{let[T,S]=r(d,g);return{x:T,y:S,r:v/n.R}}),{moved:a,floor:l}=Cv(e,s),c=null;if(n.table){let[d,g]=r(...n.table.min),[v,T]=r(...n.table.max);c={x0:d,y0:g,x1:v,y1:T}}let u=Qi(a,Math.max(4,.12*Math.max(a.x1-a.x0,a.y1-a.y0))),h=c?Qi(c,1.25+2.9):u,f=Qi(a,6),p=[h,f].map(d=>Math.max(d.x1-d.x0,d.y1-d.y0)),m=p[0]>90&&p[0]>4*p[1],M=Math.max(0,...e.map(d=>d.facts.end));return{data:n,runs:e,table:c,pockets:o,cloth:c??u,sight:m?f:h,floor:l,radii:s,end:M}}function Qi(n,e){return{x0:n.x0-e,y0:n.y0-e,x1:n.x1+e,y1:n.y1+e}}function Cv(n,e){let t={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0},i=1/0;for(let r of n)r.paths.forEach((s,o)=>{let a=e[o];for(let l=0;l<s.positions.length;l+=3){let[c,u,h]=[s.positions[l],s.positions[l+1],s.positions[l+2]];Number.isFinite(c+u+h)&&(t.x0=Math.min(t.x0,c-a),t.y0=Math.min(t.y0,u-a),t.x1=Math.max(t.x1,c+a),t.y1=Math.max(t.y1,u+a),i=Math.min(i,h-a))}});return Number.isFinite(t.x1-t.x0+t.y1-t.y0)?{moved:t,floor:Number.isFinite(i)?i:0}:{moved:{x0:-10,y0:-10,x1:10,y1:10},floor:0}}function kl(n,e){let[t,i]=[n.x1-n.x0,n.y1-n.y0],r=Math.min(t,i)/4,s=1.25+.55*2.9,o=[],[a,l]=[Math.min(64,Math.round(t/r)),Math.min(64,Math.round(i/r))];for(let c=1;c<a;c+=1)o.push([n.x0+t*c/a,n.y0-s],[n.x0+t*c/a,n.y1+s]);for(let c=1;c<l;c+=1)o.push([n.x0-s,n.y0+i*c/l],[n.x1+s,n.y0+i*c/l]);return o.filter(([c,u])=>e.pockets.every(h=>Math.hypot(h.x-c,h.y-u)>h.r+1.6))}function kr(n){if(!n.apart)return[n.solid];let e=n.shown.flatMap((t,i)=>t||i===n.solid?[i]:[]);return e.length>0?e:[n.solid]}function Gl(n,e){return n.apart?[]:n.shown.flatMap((t,i)=>t&&i!==e?[i]:[])}function zl(n,e){let[t,i]=[n.x1-n.x0,n.y1-n.y0];return{zoom:Math.min(1,Math.max((e.x1-e.x0)/t,(e.y1-e.y0)/i)),x:(e.x0+e.x1-n.x0-n.x1)/2,y:(e.y0+e.y1-n.y0-n.y1)/2}}function hs(n,e,t,i){let[r,s]=[n.x1-n.x0,n.y1-n.y0],o={columns:1,rows:e,lying:!0,scale:0};for(let u=1;u<=e;u+=1){let h=Math.ceil(e/u);for(let f of[!0,!1]){let[p,m]=f?[s,r]:[r,s],M=Math.min(t/u/p,i/h/m);M>o.scale&&(o={columns:u,rows:h,lying:f,scale:M})}}let[a,l]=[t/o.columns,i/o.rows];return{cells:Array.from({length:e},(u,h)=>({x:h%o.columns*a,y:Math.floor(h/o.columns)*l,width:a,height:l})),lying:o.lying}}function Hl(n,e,t){return n.findIndex(i=>e>=i.x&&e<i.x+i.width&&t>=i.y&&t<i.y+i.height)}var ip=.03,Pv=.4;function Vl(n,e,t){let i=Math.hypot(n[3*t]-e[3*t],n[3*t+1]-e[3*t+1],n[3*t+2]-e[3*t+2]),r=Math.min(1,Math.max(0,(i-ip)/(Pv-ip)));return r*r*(3-2*r)}var Gr=class{constructor(e,t){this.stage=e;this.still=t;let i=this.canvas.getContext("2d");if(!i)throw new Error("this browser has no canvas");this.pen=i}stage;still;canvas=document.createElement("canvas");pen;marksOf=new Map;lines=new Map;width=1;height=1;ratio=1;closer=1;middle=[0,0];shift=[0,0];drawn=null;look(){this.close(null)}close(e){let{zoom:t,x:i,y:r}=e?zl(this.stage.sight,e):{zoom:1,x:0,y:0};this.closer=1/t,this.middle=[i,r],this.shift=[0,0]}orbit(e,t){this.pan(-e,t)}zoom(e){this.closer=Math.min(25,Math.max(.5,this.closer/e))}pan(e,t){this.shift[0]-=e*this.height,this.shift[1]+=t*this.height}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=Math.min(2,window.devicePixelRatio||1),this.canvas.width=Math.round(this.width*this.ratio),this.canvas.height=Math.round(this.height*this.ratio)}draw(e,t,i){this.drawn={frame:e,choice:t};let{pen:r,ratio:s}=this;r.setTransform(s,0,0,s,0,0),r.clearRect(0,0,this.width,this.height);let o=kr(t),{cells:a,lying:l}=hs(this.stage.sight,o.length,this.width,this.height);return o.forEach((c,u)=>{let h=a[u];r.save(),r.beginPath(),r.rect(h.x,h.y,h.width,h.height),r.clip(),this.one(e,t,c,i,this.lens(h,l)),r.restore()}),!1}pick(e,t){if(!this.drawn)return-1;let{frame:i,choice:r}=this.drawn,s=kr(r),{cells:o,lying:a}=hs(this.stage.sight,s.length,this.width,this.height),l=Hl(o,e,t);if(l<0)return-1;let c=this.lens(o[l],a),u=i.scatters[s[l]],h={ball:-1,distance:18};for(let f=0;f<u.present.length;f+=1){let[p,m]=Mr(c,u.positions[3*f],u.positions[3*f+1]),M=Math.hypot(p-e,m-t);u.present[f]&&M<h.distance&&(h={ball:f,distance:M})}return h.ball}dispose(){this.canvas.remove()}lens(e,t){let{sight:i}=this.stage,[r,s]=[i.x1-i.x0,i.y1-i.y0];return{scale:.96*this.closer*Math.min(e.width/(t?s:r),e.height/(t?r:s)),lying:t,px:e.x+e.width/2+this.shift[0],py:e.y+e.height/2+this.shift[1],cx:(i.x0+i.x1)/2+this.middle[0],cy:(i.y0+i.y1)/2+this.middle[1]}}one(e,t,i,r,s){let o=e.scatters[i],a=Gl(t,i);this.table(s),t.trails&&(a.forEach(l=>this.trails(l,e.time,!0,s)),this.trails(i,e.time,!1,s)),t.marks&&this.rings(i,e.time,ha*r,s),this.ring(s,o,t.ball,1.2,.1,"rgba(255,255,255,.8)");for(let l=0;l<this.stage.radii.length;l+=1)o.present[l]&&this.ball(s,o,l);a.forEach(l=>this.ghosts(s,e.scatters[l],o,l));for(let l of t.called)this.ring(s,o,l,1.11,.18,"#ffe98a")}table(e){let{pen:t,stage:i}=this,r=(o,a)=>{t.beginPath();for(let[l,c]of o)t.lineTo(...Mr(e,l,c));t.closePath(),t.fillStyle=a,t.fill()},s=o=>[[o.x0,o.y0],[o.x1,o.y0],[o.x1,o.y1],[o.x0,o.y1]];if(i.table){r(np(Qi(i.table,1.25+2.9),2.4),"#6b3a20"),r(np(Qi(i.table,1.25+2.9-.3),2.1),"#5a2f19"),r(qs(Qi(i.table,1.25),i.pockets).points,"#0d5f46");for(let[o,a]of kl(i.table,i))this.disc(e,o,a,.24,"#efe6d2")}r(s(i.cloth),Bl);for(let{x:o,y:a,r:l}of i.pockets)this.disc(e,o,a,l,"#0a0908")}disc(e,t,i,r,s){let{pen:o}=this;o.beginPath(),o.arc(...Mr(e,t,i),Math.max(.5,r*e.scale),0,2*Math.PI),o.fillStyle=s,o.fill()}ball(e,t,i){let{pen:r,stage:s}=this,{colour:o,striped:a,label:l,spotted:c}=Br(s.data.balls[i].id,i),[u,h]=[t.positions[3*i],t.positions[3*i+1]],[f,p]=Mr(e,u,h),m=Math.max(1.5,s.radii[i]*e.scale);this.disc(e,u+.12,h-.12,s.radii[i],"rgba(0,0,0,.3)"),r.save(),r.beginPath(),r.arc(f,p,m,0,2*Math.PI),r.fillStyle=a?"#f4efe2":o,r.fill(),r.clip(),a&&(r.fillStyle=o,r.fillRect(f-m,p-.55*m,2*m,1.1*m)),c&&(r.fillStyle="#c4202b",r.beginPath(),r.arc(f,p,.16*m,0,2*Math.PI),r.fill()),r.restore(),l&&m>5&&(r.fillStyle="#f4efe2",r.beginPath(),r.arc(f,p,.5*m,0,2*Math.PI),r.fill(),r.fillStyle="#16181a",r.font=`700 ${Math.round((l.length>2?.42:l.length>1?.58:.75)*m)}px Arial, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.fillText(l,f,p+.03*m))}ghosts(e,t,i,r){let{pen:s,stage:o}=this,{cloth:a,dash:l}=ln(r);for(let c=0;c<o.radii.length;c+=1){let u=t.present[c]?i.present[c]?Vl(t.positions,i.positions,c):1:0;u<=0||(s.globalAlpha=u,s.beginPath(),s.arc(...Mr(e,t.positions[3*c],t.positions[3*c+1]),Math.max(1.5,o.radii[c]*e.scale),0,2*Math.PI),s.fillStyle=`${a}44`,s.fill(),s.strokeStyle=a,s.lineWidth=2,s.setLineDash(l.map(h=>h*.6)),s.stroke())}s.globalAlpha=1,s.setLineDash([])}ring(e,t,i,r,s,o){if(i<0||!t.present[i])return;let{pen:a}=this;a.beginPath(),a.arc(...Mr(e,t.positions[3*i],t.positions[3*i+1]),r*this.stage.radii[i]*e.scale,0,2*Math.PI),a.strokeStyle=o,a.lineWidth=Math.max(1.2,s*e.scale),a.stroke()}rings(e,t,i,r){let{pen:s}=this,o=this.marksOf.get(e);o||(o=Ol(this.stage,this.stage.runs[e]),this.marksOf.set(e,o));for(let a of o){let l=(t-a.at)/i;l<0||l>1||(s.beginPath(),s.arc(...Mr(r,a.x,a.y),a.r*r.scale*(this.still()?1:1+.9*l),0,2*Math.PI),s.strokeStyle=`rgba(255,247,217,${.9*(1-l)})`,s.lineWidth=2,s.stroke())}}trails(e,t,i,r){let{pen:s,stage:o}=this,a=this.lines.get(e);a||(a=o.runs[e].paths.map((l,c)=>Nl(l,o.runs[e].leaves[c])),this.lines.set(e,a)),s.lineWidth=1.5,s.globalAlpha=.7,s.setLineDash(i?[5,4]:[]),a.forEach((l,c)=>{s.strokeStyle=i?ln(e).cloth:Br(o.data.balls[c].id,c).colour,s.beginPath();for(let u=0;u<l.length&&l[u]<=t;u+=3)if(s.lineTo(...Mr(r,l[u+1],l[u+2])),u+3<l.length&&l[u+3]>t){let h=(t-l[u])/(l[u+3]-l[u]);s.lineTo(...Mr(r,l[u+1]+h*(l[u+4]-l[u+1]),l[u+2]+h*(l[u+5]-l[u+2])))}s.stroke()}),s.globalAlpha=1,s.setLineDash([])}};function np(n,e){return[[n.x1-e,n.y1-e,0],[n.x0+e,n.y1-e,1],[n.x0+e,n.y0+e,2],[n.x1-e,n.y0+e,3]].flatMap(([i,r,s])=>Array.from({length:9},(o,a)=>{let l=(s+a/8)*Math.PI/2;return[i+e*Math.cos(l),r+e*Math.sin(l)]}))}function Mr(n,e,t){let[i,r]=[(e-n.cx)*n.scale,(t-n.cy)*n.scale];return n.lying?[n.px+r,n.py+i]:[n.px+i,n.py-r]}var Wl=class{constructor(e){this.end=e;this.base=e>=.5&&e<=120?1:e/10||1}end;shown=0;running=!1;factor=1;last=0;request=0;listeners=new Set;base;get time(){return this.shown}get playing(){return this.running}get rate(){return this.factor}set rate(e){this.factor=e,this.tell()}listen(e){this.listeners.add(e)}seek(e){this.shown=Math.min(this.end,Math.max(0,Number.isFinite(e)?e:0)),this.tell()}play(){this.running||(this.shown>=this.end&&(this.shown=0),this.running=!0,this.last=performance.now(),this.request=requestAnimationFrame(this.step),this.tell())}pause(){cancelAnimationFrame(this.request),this.running&&(this.running=!1,this.tell())}stop(){this.listeners.clear(),this.pause()}step=e=>{let t=Math.min(.25,Math.max(0,(e-this.last)/1e3));this.last=e,this.shown=Math.min(this.end,this.shown+t*this.factor*this.base),this.running=this.shown<this.end,this.running&&(this.request=requestAnimationFrame(this.step)),this.tell()};tell(){for(let e of this.listeners)e(this)}};function me(n,e={},...t){let i=document.createElement(n);return rp(i,e),i.append(...t),i}var Lv="http://www.w3.org/2000/svg";function ar(n,e={},...t){let i=document.createElementNS(Lv,n);return rp(i,e),i.append(...t),i}function Xl(n){return ar("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},ar("path",{d:n}))}function pa(n,e,t){let i=me("button",{type:"button","aria-label":n,title:n},...e);return i.addEventListener("click",t),i}function rp(n,e){for(let[t,i]of Object.entries(e))i!==void 0&&i!==!1&&n.setAttribute(t,i===!0?"":String(i))}function zn(n,e){n.textContent!==e&&(n.textContent=e)}function th(n,e=5){return n>0&&Number.isFinite(n)?Math.min(15,Math.max(0,e-Math.ceil(Math.log10(n)))):3}function fs(n,e=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let t=Math.abs(n);if(t>=1e6||t<.001)return n.toExponential(e-2).replace(/\.?0*e\+?/,"e");let i=n.toPrecision(e);return i.includes("e")?String(Number(i)):i.replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"")}function Oi(n,e){return n.toFixed(th(e))}var Dv=7,Iv=10;async function sp(n,e){let t=n.counts.reduce((f,p)=>f+p,0),i=e.rotates?Iv:Dv,r=await Fv(Uv(n.bytes));if(r.length!==t*i*4)throw new Error(`the knots hold ${r.length} bytes where ${t} knots of ${i} columns need ${t*i*4}`);let s=e.scene.speed_scale/e.R,o=(f,p)=>Nv(r,f*t,t,p),a=o(0,1),l=[1,2,3].map(f=>o(f,1)),c=[4,5,6].map(f=>o(f,s)),u=e.rotates?[7,8,9].map(f=>o(f,s)):[],h=0;return n.counts.map(f=>{let p=h+f,m=d=>d.subarray(h,p),M=new Fl(m(a),ih(l.map(m)),ih(c.map(m)),ih(u.map(m)));return h=p,M})}function Uv(n){let e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i+=1)t[i]=e.charCodeAt(i);return t}async function Fv(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate-raw"));return new Uint8Array(await new Response(e).arrayBuffer())}function Nv(n,e,t,i){let r=h=>e*4+h*t,[s,o,a,l]=[r(0),r(1),r(2),r(3)],c=new DataView(new ArrayBuffer(4)),u=new Float64Array(t);for(let h=0;h<t;h+=1){let f=n[l+h]<<24|n[a+h]<<16|n[o+h]<<8|n[s+h];c.setInt32(0,f),u[h]=c.getFloat32(0)*i}return u}function ih(n){let[e,t,i]=n;if(!e)return new Float64Array(0);let r=new Float64Array(3*e.length);for(let s=0;s<e.length;s+=1)r[3*s]=e[s],r[3*s+1]=t[s],r[3*s+2]=i[s];return r}function Ov(n,e,t,i){let r=Math.hypot(e,t,i),s=r>1e-8?Math.sin(r/2)/r:.5,[o,a,l,c]=[s*e,s*t,s*i,Math.cos(r/2)],[u,h,f,p]=n;n[0]=c*u+o*p+a*f-l*h,n[1]=c*h-o*f+a*p+l*u,n[2]=c*f+o*h-a*u+l*p,n[3]=c*p-o*u-a*h-l*f;let m=Math.hypot(n[0],n[1],n[2],n[3]);for(let M=0;M<4;M+=1)n[M]/=m}function op(n,e,t,i,r,s,o){let a=(d,g)=>e[t+d]+g*(e[i+d]-e[t+d]),[l,c,u]=[a(0,s),a(1,s),a(2,s)],[h,f,p]=[a(0,o),a(1,o),a(2,o)],m=r*(o-s),M=m*m/12;Ov(n,m*(l+h)/2+M*(f*u-p*c),m*(c+f)/2+M*(p*l-h*u),m*(u+p)/2+M*(h*c-f*l))}var ql=class{constructor(e){this.path=e;let{times:t,spins:i,count:r}=e,s=new Float64Array([0,0,0,1]);for(let o=0;o<r;o+=1){this.push(t[o],o,0,s);let a=o+1<r?t[o+1]-t[o]:0;if(a>0&&i.length>0){let[l,c]=[3*o,3*o+3],u=Bv(i,l,c,a);for(let h=1;h<=u;h+=1)op(s,i,l,c,a,(h-1)/u,h/u),h<u&&this.push(t[o]+a*h/u,o,h/u,s)}}}path;times=[];nodes=[];knots=[];parts=[];hint=0;at(e,t){let{times:i,nodes:r,path:s}=this;if(i.length-1<0||s.spins.length===0){t.set([0,0,0,1]);return}let a=this.find(e);for(let c=0;c<4;c+=1)t[c]=r[4*a+c];let l=this.knots[a];if(e>i[a]&&l+1<s.count){let c=s.times[l+1]-s.times[l],u=Math.min(1,(e-s.times[l])/c);op(t,s.spins,3*l,3*l+3,c,this.parts[a],u)}}push(e,t,i,r){this.times.push(e),this.knots.push(t),this.parts.push(i),this.nodes.push(r[0],r[1],r[2],r[3])}find(e){let{times:t}=this,i=this.hint;if(t[i]<=e&&(i+1===t.length||t[i+1]>e))return i;let r=0,s=t.length;for(;r<s;){let o=r+s>>1;t[o]<=e?r=o+1:s=o}return this.hint=Math.max(0,r-1)}};function Bv(n,e,t,i){let[r,s,o,a,l,c]=[n[e],n[e+1],n[e+2],n[t],n[t+1],n[t+2]],u=Math.hypot(l*o-c*s,c*r-a*o,a*s-l*r),[h,f]=[Math.hypot(r,s,o),Math.hypot(a,l,c)];return u<=1e-9*h*f?1:Math.min(4096,Math.max(1,Math.ceil(i*Math.max(h,f)/.5)))}async function ap(n){let e=new Map(n.balls.map((t,i)=>[t.id,i]));return Promise.all(n.runs.map(async(t,i)=>{let r=await sp(t.knots,n),s=new Float64Array(n.balls.length).fill(1/0),o=t.events.map(([l,c,u,h])=>({at:Math.fround(l),time:l,kind:c,a:u,b:h}));for(let l of o){let c=e.get(l.a);l.kind==="pocket"&&c!==void 0&&(s[c]=l.at)}let a=n.rotates?r.map(l=>new ql(l)):[];return{facts:t,index:i,paths:r,turnings:a,events:o,leaves:s}}))}function Yl(n){switch(n.kind){case"ball-ball":return`${n.a} hits ${n.b}`;case"ball-cushion":return`${n.a} meets cushion ${n.b}`;case"stop":return`${n.a} stops`;case"slide-to-roll":return`${n.a} starts to roll`;case"spin-end":return`${n.a} stops spinning`;case"contact-begin":return`${n.a} and ${n.b} stay in contact`;case"contact-end":return`${n.a} and ${n.b} are no longer in contact`;case"pocket":return`${n.a} falls in pocket ${n.b.replace(/^p/,"")}`;default:return[n.kind,n.a,n.b].filter(Boolean).join(" ")}}function da(n,e){let t=0,i=n.length;for(;t<i;){let r=t+i>>1;n[r].at<=e?t=r+1:i=r}return t}var lp="M8 5v14l11-7z",kv="M6 5h4v14H6zM14 5h4v14h-4z",Gv="M6 6l8.5 6L6 18zM16 6h2v12h-2z",zv="M18 6l-8.5 6L18 18zM6 6h2v12H6z",Hv="M11 21v-7L5.6 8.6 4 10V4h6L8.4 5.6 12 9.2l3.6-3.6L14 4h6v6l-1.6-1.4L13 14v7z",Kl=class{constructor(e,t,i,r){this.stage=e;this.clock=t;let s=e.data.scene.time_unit;this.shape=ar("path",{d:lp}),this.play=pa("Play",[ar("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},this.shape)],()=>i.toggle()),this.play.classList.add("rp-play"),this.rates=me("select",{"aria-label":"Speed",title:t.base===1?`1x: one ${s} in one second`:"1x: the longest run in ten seconds"}),this.rates.append(...Xs.map(h=>me("option",{value:h,selected:h===1},`${h}×`))),this.rates.addEventListener("change",()=>i.rate(Number(this.rates.value))),this.scrubber=me("input",{type:"range",min:0,max:e.end||1,step:"any",value:0,class:"rp-scrub","aria-label":"Time"}),this.scrubber.addEventListener("input",()=>i.seek(Number(this.scrubber.value)));let o=me("div",{class:"rp-transport",role:"group","aria-label":"Playback"},pa("Event before",[Xl(zv)],()=>i.event(-1)),this.play,pa("Next event",[Xl(Gv)],()=>i.event(1))),a=me("div",{class:"rp-row"},o,me("span",{class:"rp-clock"},this.now,me("span",{class:"rp-end"},` / ${Oi(e.end,e.end)} ${s}`)),this.rates);if(e.data.partings.length>0){let h=e.data.partings[0].time;this.jump=pa("Jump to the first divergence",[Xl(Hv),me("span",{},"First divergence"),me("span",{class:"rp-at"},`${Oi(h,e.end)} ${s}`)],()=>i.parting()),this.jump.classList.add("rp-jump"),a.append(this.jump)}else e.runs.length>1&&a.append(me("span",{class:"rp-none"},"No collision order differs"));a.append(this.last);let l=me("div",{class:"rp-views",role:"group","aria-label":"Camera"}),c=r?[["above","From above"],["free","Free"],["flat","Flat"]]:[["flat","Flat"]];for(let[h,f]of c){let p=me("button",{type:"button","aria-pressed":"false"},f);p.addEventListener("click",()=>i.look(h)),this.cameras.set(h,p),l.append(p)}this.boxes={apart:e.runs.length>1?this.box("Side by side",h=>i.apart(h)):null,trails:this.box("Trails",h=>i.trails(h)),marks:this.box("Hits",h=>i.marks(h))};let u=me("div",{class:"rp-row rp-looks"},l);for(let h of[this.boxes.apart,this.boxes.trails,this.boxes.marks])h?.parentElement&&u.append(h.parentElement);this.element=me("div",{class:"rp-controls"},me("div",{class:"rp-time"},this.scrubber,this.ticks),a,u)}stage;clock;element;scrubber;play;shape;now=me("span",{class:"rp-now"});last=me("span",{class:"rp-event"});rates;jump=null;ticks=ar("svg",{class:"rp-ticks",viewBox:"0 0 1000 12",preserveAspectRatio:"none","aria-hidden":"true"});cameras=new Map;boxes;spoken=-1/0;tell(e){let{clock:t,stage:i}=this,r=Oi(t.time,i.end);zn(this.now,r),this.scrubber.value=String(t.time),this.scrubber.style.setProperty("--rp-part",String(i.end>0?t.time/i.end:0));let s=da(e,t.time),o=s>0?`event ${s} of ${e.length}: ${Yl(e[s-1])}`:`before the first of ${e.length} events`,a=e.length>0?o:"no events";zn(this.last,a);let l=performance.now();(!t.playing||l-this.spoken>1e3)&&(this.spoken=l,this.scrubber.setAttribute("aria-valuetext",`${r} ${i.data.scene.time_unit}, ${a}`));let c=t.playing?"Pause":"Play";this.play.title!==c&&(this.play.title=c,this.play.setAttribute("aria-label",c),this.shape.setAttribute("d",t.playing?kv:lp)),this.rates.value=String(t.rate)}choose(e){for(let[t,i]of this.cameras)i.setAttribute("aria-pressed",String(t===e.camera));this.boxes.apart&&(this.boxes.apart.checked=e.apart),this.boxes.trails.checked=e.trails,this.boxes.marks.checked=e.marks}mark(e){let{data:t,end:i}=this.stage,r=u=>(1e3*u/(i||1)).toFixed(2),s={"ball-ball":9,"ball-cushion":6,pocket:9,stop:3},o=(u,h)=>ar("path",{d:h,class:`rp-tick ${u}`,"vector-effect":"non-scaling-stroke"}),a=Object.entries(s).map(([u,h])=>{let f=e.filter(p=>p.kind===u).map(p=>`M${r(p.at)} 0v${h}`);return o(`rp-${u}`,f.join(""))}),l=t.partings.map(u=>o("rp-part",`M${r(u.time)} 0v12`)),c=t.horizon===null?[]:[o("rp-horizon",`M${r(t.horizon)} 0v12`)];this.ticks.replaceChildren(...a,...c,...l)}box(e,t){let i=me("input",{type:"checkbox"});return i.addEventListener("change",()=>t(i.checked)),me("label",{class:"rp-check"},i,e),i}};var $l=class{constructor(e){this.stage=e;let t=e.data.balls.length;this.scatters=e.runs.map(i=>({run:i,positions:new Float64Array(3*t),velocities:new Float64Array(3*t),spins:new Float64Array(3*t),orientations:new Float64Array(4*t).map((r,s)=>s%4===3?1:0),present:new Uint8Array(t)}))}stage;time=0;scatters;motion=Gn();quaternion=new Float64Array(4);go(e){this.time=e;let{motion:t,quaternion:i,stage:r}=this;for(let s of this.scatters){let{run:o}=s;for(let a=0;a<r.radii.length;a+=1){let l=o.paths[a],c=l!==void 0&&l.at(e,t);s.present[a]=c&&e<o.leaves[a]?1:0,c&&(s.positions.set(t.position,3*a),s.velocities.set(t.velocity,3*a),s.spins.set(t.spin,3*a)),r.data.rotates&&c&&(o.turnings[a].at(e,i),s.orientations.set(i,4*a))}}}};function cp(n,e){let t=new Map,i=0,r=0;n.addEventListener("pointerdown",o=>{t.set(o.pointerId,{x:o.clientX,y:o.clientY}),i=t.size===1?0:5,r=0,n.setPointerCapture(o.pointerId)}),n.addEventListener("pointermove",o=>{let a=t.get(o.pointerId),l=e.view();if(!a||!l)return;let[c,u]=[o.clientX-a.x,o.clientY-a.y];i+=Math.hypot(c,u),t.set(o.pointerId,{x:o.clientX,y:o.clientY});let{width:h,height:f}=n.getBoundingClientRect();if(t.size===1)o.shiftKey||(o.buttons&2)!==0?l.pan(-c/f,u/f):l.orbit(c/h,u/f);else{let[p,m]=[...t.values()],M=Math.hypot(p.x-m.x,p.y-m.y);r>0&&M>0&&l.zoom(r/M),r=M,l.pan(-c/2/f,u/2/f)}e.again()});let s=o=>{if(t.delete(o.pointerId)&&i<5&&o.type==="pointerup"){let a=n.getBoundingClientRect();e.choose(e.view()?.pick(o.clientX-a.left,o.clientY-a.top)??-1)}r=0};n.addEventListener("pointerup",s),n.addEventListener("pointercancel",s),n.addEventListener("contextmenu",o=>o.preventDefault()),n.addEventListener("wheel",o=>{(o.ctrlKey||document.activeElement===n)&&(o.preventDefault(),e.view()?.zoom(Math.exp(.0015*o.deltaY)),e.again())},{passive:!1})}var Vv=[[["Space"],"play, pause"],[["←","→"],"back and on by a hundredth of the shot; with Alt by a thousandth"],[[",","."],"event before, next event"],[["d"],"first divergence, then the next"],[["Home","End"],"start, end"],[["[","]"],"slower, faster"],[["v"],"next camera"],[["t"],"trails"],[["Shift + arrows"],"turn and tilt the camera"],[["+","−","0"],"closer, farther, the whole table"],[["?"],"this list"]];function up(){let n=Vv.map(([e,t])=>me("div",{},me("dt",{},...e.map(i=>me("kbd",{},i))),me("dd",{},t)));return me("details",{class:"rp-keys"},me("summary",{},"Keys"),me("dl",{},...n))}function hp(n,e){n.addEventListener("keydown",t=>{!t.ctrlKey&&!t.metaKey&&Wv(t,e)&&t.preventDefault()})}function Wv(n,e){let{actions:t}=e,i=n.target,r=i.closest("select, button, summary, input:not([type=range])");if(r&&(r.matches("select")||n.key===" "||n.key==="Enter"||n.key.startsWith("Arrow")&&r.matches("input")))return!1;let o={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key];if(o&&n.shiftKey)return e.view()?.orbit(.04*o[0],.04*o[1]),e.again(),!0;if(o&&(o[0]!==0||i.matches("input[type=range]")))return t.nudge((o[0]-o[1])*(n.altKey?.001:.01)),!0;let l={" ":()=>t.toggle(),".":()=>t.event(1),",":()=>t.event(-1),d:()=>t.parting(),Home:()=>t.seek(0),End:()=>t.seek(e.end()),PageUp:()=>t.nudge(.1),PageDown:()=>t.nudge(-.1),"[":()=>t.faster(-1),"]":()=>t.faster(1),v:()=>e.nextCamera(),t:()=>e.toggleTrails(),"+":()=>Zl(e,.85),"=":()=>Zl(e,.85),"-":()=>Zl(e,1/.85),0:()=>Zl(e,0),"?":()=>{e.keys.open=!e.keys.open}}[n.key];return l?.(),l!==void 0}function Zl(n,e){e===0?n.actions.look(n.camera()):(n.view()?.zoom(e),n.again())}var Jl=class{element;shown=[];solid=[];rows=[];constructor(e,t){this.element=me("fieldset",{class:"rp-legend"},me("legend",{},"Engines"));let i=`rp-solid-${Math.random().toString(36).slice(2)}`,r=e.data.scene.time_unit;for(let{facts:s,index:o}of e.runs){let a=me("input",{type:"checkbox","aria-label":`Show ${s.label}`});a.addEventListener("change",()=>t.show(o,a.checked));let l=me("input",{type:"radio",name:i,"aria-label":`Balls of ${s.label} solid`});l.addEventListener("change",()=>t.solid(o)),this.shown.push(a),this.solid.push(l);let c=me("span",{class:"rp-name"},s.label,...s.reference?[me("small",{},"reference")]:[]),u=me("span",{class:"rp-ending"},Xv(s,`${Oi(s.end,e.end)} ${r}`)),h=me("div",{class:"rp-run"},me("label",{class:"rp-show"},a,Ys(o),c));e.runs.length>1&&h.append(me("label",{class:"rp-solid"},l,"solid")),h.append(u),e.data.partings.forEach((f,p)=>{if(f.runs[0]===o){let m=e.runs[f.runs[1]]?.facts.label??"",M=me("button",{type:"button",class:"rp-parts",title:f.words},`parts from ${m} at ${Oi(f.time,e.end)} ${r}`);M.addEventListener("click",()=>t.parting(p)),h.append(M)}}),this.rows.push(h),this.element.append(h)}}choose(e){this.shown.forEach((t,i)=>{t.checked=e.shown[i]||i===e.solid,t.disabled=i===e.solid,this.solid[i].checked=i===e.solid,this.rows[i].classList.toggle("rp-off",!t.checked)})}};function Xv(n,e){let t=n.ending.startsWith(`${n.engine}: `)?n.ending.slice(n.engine.length+2):n.ending;return/\d/.test(t)?t:`${t}, ${e}`}function Ys(n){let e=ar("line",{x1:0,y1:5,x2:34,y2:5,class:`rp-ink${n%7}`,"stroke-width":2.5,"stroke-dasharray":ln(n).dash.join(" ")||"none"});return ar("svg",{viewBox:"0 0 34 10",class:"rp-swatch","aria-hidden":"true"},e)}var qv="uplot",Yv="u-hz",Kv="u-vt",$v="u-title",Zv="u-wrap",Jv="u-under",Qv="u-over",jv="u-axis",ms="u-off",eM="u-select",tM="u-cursor-x",iM="u-cursor-y",nM="u-cursor-pt",rM="u-legend",sM="u-live",oM="u-inline",aM="u-series",lM="u-marker",fp="u-label",cM="u-value",ga="width",xa="height";var pp="bottom",Ks="left",nh="right",Mh="#000",dp=Mh+"0",rh="mousemove",mp="mousedown",sh="mouseup",gp="mouseenter",xp="mouseleave",_p="dblclick",uM="resize",hM="scroll",vp="change",ic="dppxchange",Sh="--",to=typeof window<"u",uh=to?document:null,Zs=to?window:null,fM=to?navigator:null,Ft,Ql;function hh(){let n=devicePixelRatio;Ft!=n&&(Ft=n,Ql&&ph(vp,Ql,hh),Ql=matchMedia(`(min-resolution: ${Ft-.001}dppx) and (max-resolution: ${Ft+.001}dppx)`),gs(vp,Ql,hh),Zs.dispatchEvent(new CustomEvent(ic)))}function un(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function fh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function Hn(n,e,t,i){let r=uh.createElement(n);return e!=null&&un(r,e),t?.insertBefore(r,i),r}function wn(n,e){return Hn("div",n,e)}var Mp=new WeakMap;function lr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=Mp.get(n);s!=o&&(n.style.transform=s,Mp.set(n,s),e<0||t<0||e>i||t>r?un(n,ms):fh(n,ms))}var Sp=new WeakMap;function yp(n,e,t){let i=e+t,r=Sp.get(n);i!=r&&(Sp.set(n,i),n.style.background=e,n.style.borderColor=t)}var bp=new WeakMap;function Ep(n,e,t,i){let r=e+""+t,s=bp.get(n);r!=s&&(bp.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var yh={passive:!0},pM={...yh,capture:!0};function gs(n,e,t,i){e.addEventListener(n,t,i?pM:yh)}function ph(n,e,t,i){e.removeEventListener(n,t,yh)}to&&hh();function Vn(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:hn((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function Qp(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var jp=n=>n!=null,ed=n=>n!=null&&n>0,sc=Qp(jp),dM=Qp(ed);function mM(n,e,t,i=0,r=!1){let s=r?dM:sc,o=r?ed:jp;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function oc(n,e,t,i){let r=Ap(n),s=Ap(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Sr:td,a=r==1?hn:Tn,l=s==1?Tn:hn,c=a(o(Si(n))),u=l(o(Si(e))),h=Js(t,c),f=Js(t,u);return t==10&&(c<0&&(h=Wt(h,-c)),u<0&&(f=Wt(f,-u))),i||t==2?(n=h*r,e=f*s):(n=sd(n,h),e=ac(e,f)),[n,e]}function bh(n,e,t,i){let r=oc(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var Eh=.1,wp={mode:3,pad:Eh},va={pad:0,soft:null,mode:0},gM={min:va,max:va};function nc(n,e,t,i){return lc(t)?Tp(n,e,t):(va.pad=t,va.soft=i?0:null,va.mode=i?3:0,Tp(n,e,gM))}function Dt(n,e){return n??e}function xM(n,e,t){for(e=Dt(e,0),t=Dt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Tp(n,e,t){let i=t.min,r=t.max,s=Dt(i.pad,0),o=Dt(r.pad,0),a=Dt(i.hard,-Vt),l=Dt(r.hard,Vt),c=Dt(i.soft,Vt),u=Dt(r.soft,-Vt),h=Dt(i.mode,0),f=Dt(r.mode,0),p=e-n,m=Sr(p),M=ji(Si(n),Si(e)),d=Sr(M),g=Si(d-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,h==2&&c!=Vt&&(s=0),f==2&&u!=-Vt&&(o=0)));let v=p||M||1e3,T=Sr(v),S=Js(10,hn(T)),C=v*(p==0?n==0?.1:1:s),A=Wt(sd(n-C,S/10),24),x=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Vt,E=ji(a,A<x&&n>=x?x:Wn(x,A)),B=v*(p==0?e==0?.1:1:o),D=Wt(ac(e+B,S/10),24),L=e<=u&&(f==1||f==3&&D>=u||f==2&&D<=u)?u:-Vt,G=Wn(l,D>L&&e<=L?L:ji(L,D));return E==G&&E==0&&(G=100),[E,G]}var _M=new Intl.NumberFormat(to?fM.language:"en-US"),wh=n=>_M.format(n),fn=Math,tc=fn.PI,Si=fn.abs,hn=fn.floor,Mi=fn.round,Tn=fn.ceil,Wn=fn.min,ji=fn.max,Js=fn.pow,Ap=fn.sign,Sr=fn.log10,td=fn.log2,vM=(n,e=1)=>fn.sinh(n)*e,oh=(n,e=1)=>fn.asinh(n/e),Vt=1/0;function Rp(n){return(Sr((n^n>>31)-(n>>31))|0)+1}function dh(n,e,t){return Wn(ji(n,e),t)}function id(n){return typeof n=="function"}function Ct(n){return id(n)?n:()=>n}var MM=()=>{},nd=n=>n,rd=(n,e)=>e,SM=n=>null,Cp=n=>!0,Pp=(n,e)=>n==e,yM=/\.\d*?(?=9{6,}|0{6,})/gm,xs=n=>{if(ad(n)||Hr.has(n))return n;let e=`${n}`,t=e.match(yM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${xs(r)}e${s}`}return Wt(n,i)};function ps(n,e){return xs(Wt(xs(n/e))*e)}function ac(n,e){return xs(Tn(xs(n/e))*e)}function sd(n,e){return xs(hn(xs(n/e))*e)}function Wt(n,e=0){if(ad(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mi(i)/t}var Hr=new Map;function od(n){return((""+n).split(".")[1]||"").length}function Sa(n,e,t,i){let r=[],s=i.map(od);for(let o=e;o<t;o++){let a=Si(o),l=Wt(Js(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=n==10?u:Wt(u,h);r.push(f),Hr.set(f,h)}}return r}var Ma={},Th=[],Qs=[null,null],zr=Array.isArray,ad=Number.isInteger,bM=n=>n===void 0;function Lp(n){return typeof n=="string"}function lc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function EM(n){return n!=null&&typeof n=="object"}var wM=Object.getPrototypeOf(Uint8Array),ld="__proto__";function js(n,e=lc){let t;if(zr(n)){let i=n.find(r=>r!=null);if(zr(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=js(n[r],e)}else t=n.slice()}else if(n instanceof wM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ld&&(t[i]=js(n[i],e))}else t=n;return t}function gi(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=ld&&(lc(n[r])?gi(n[r],js(i[r])):n[r]=js(i[r]))}return n}var TM=0,AM=1,RM=2;function CM(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function PM(n,e){if(IM(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return UM(o[0])||(o=DM(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=e?e[o][c]:AM,p=[];for(let m=0;m<u.length;m++){let M=u[m],d=s.get(l[m]);M===null?f!=TM&&(h[d]=M,f==RM&&p.push(d)):h[d]=M}CM(h,p,r),i.push(h)}}return i}var LM=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function DM(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function IM(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function UM(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ji(1,hn((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var cd=["January","February","March","April","May","June","July","August","September","October","November","December"],ud=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function hd(n){return n.slice(0,3)}var FM=ud.map(hd),NM=cd.map(hd),OM={MMMM:cd,MMM:NM,WWWW:ud,WWW:FM};function ma(n){return(n<10?"0":"")+n}function BM(n){return(n<10?"00":n<100?"0":"")+n}var kM={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ma(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ma(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ma(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ma(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ma(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>BM(n.getMilliseconds())};function Ah(n,e){e=e||OM;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?kM[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var GM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zM(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==GM?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var fd=n=>n%1==0,rc=[1,2,2.5,5],HM=Sa(10,-32,0,rc),pd=Sa(10,0,32,rc),VM=pd.filter(fd),ds=HM.concat(pd),Rh=`
`,dd="{YYYY}",Dp=Rh+dd,md="{M}/{D}",_a=Rh+md,jl=_a+"/{YY}",gd="{aa}",WM="{h}:{mm}",$s=WM+gd,Ip=Rh+$s,Up=":{ss}",Ot=null;function xd(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Sa(10,0,3,rc).filter(fd):Sa(10,-3,0,rc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,dd,Ot,Ot,Ot,Ot,Ot,Ot,1],[r*28,"{MMM}",Dp,Ot,Ot,Ot,Ot,Ot,1],[r,md,Dp,Ot,Ot,Ot,Ot,Ot,1],[i,"{h}"+gd,jl,Ot,_a,Ot,Ot,Ot,1],[t,$s,jl,Ot,_a,Ot,Ot,Ot,1],[e,Up,jl+" "+$s,Ot,_a+" "+$s,Ot,Ip,Ot,1],[n,Up+".{fff}",jl+" "+$s,Ot,_a+" "+$s,Ot,Ip,Ot,1]];function u(h){return(f,p,m,M,d,g)=>{let v=[],T=d>=o,S=d>=s&&d<o,C=h(m),A=Wt(C*n,3),x=ah(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),E=Wt(x*n,3);if(S||T){let B=S?d/s:0,D=T?d/o:0,L=A==E?A:Wt(ah(x.getFullYear()+D,x.getMonth()+B,1)*n,3),G=new Date(Mi(L/n)),W=G.getFullYear(),I=G.getMonth();for(let H=0;L<=M;H++){let q=ah(W+D*H,I+B*H,1),z=q-h(Wt(q*n,3));L=Wt((+q+z)*n,3),L<=M&&v.push(L)}}else{let B=d>=r?r:d,D=hn(m)-hn(A),L=E+D+ac(A-E,B);v.push(L);let G=h(L),W=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,I=d/i,H=f.axes[p]._space,q=g/H;for(;L=Wt(L+d,n==1?0:3),!(L>M);)if(I>1){let z=hn(Wt(W+I,6))%24,Q=h(L).getHours()-z;Q>1&&(Q=-1),L-=Q*i,W=(W+I)%24;let ee=v[v.length-1];Wt((L-ee)/d,3)*q>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[XM,qM,YM]=xd(1),[KM,$M,ZM]=xd(.001);Sa(2,-53,53,[1]);function Fp(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function Np(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,p;return i.map(m=>{let M=n(m),d=M.getFullYear(),g=M.getMonth(),v=M.getDate(),T=M.getHours(),S=M.getMinutes(),C=M.getSeconds(),A=d!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||S!=f&&a[6]||C!=p&&a[7]||a[1];return l=d,c=g,u=v,h=T,f=S,p=C,A(M)})}}function JM(n,e){let t=Ah(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function ah(n,e,t){return new Date(n,e,t)}function Op(n,e){return e(n)}var QM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Bp(n,e){return(t,i,r,s)=>s==null?Sh:e(n(i))}function jM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function eS(n,e){return n.series[e].fill(n,e)}var tS={show:!0,live:!0,isolate:!1,mount:MM,markers:{show:!0,width:2,stroke:jM,fill:eS,dash:"solid"},idx:null,idxs:null,values:[]};function iS(n,e){let t=n.cursor.points,i=wn(),r=t.size(n,e);$t(i,ga,r),$t(i,xa,r);let s=r/-2;$t(i,"marginLeft",s),$t(i,"marginTop",s);let o=t.width(n,e,r);return o&&$t(i,"borderWidth",o),i}function nS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function rS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function sS(n,e){return n.series[e].points.size}var lh=[0,0];function oS(n,e,t){return lh[0]=e,lh[1]=t,lh}function ec(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function ch(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var aS={show:!0,x:!0,y:!0,lock:!1,move:oS,points:{one:!1,show:iS,size:sS,width:0,stroke:rS,fill:nS},bind:{mousedown:ec,mouseup:ec,click:ec,dblclick:ec,mousemove:ch,mouseleave:ch,mouseenter:ch},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},_d={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ch=gi({},_d,{filter:rd}),vd=gi({},Ch,{size:10}),Md=gi({},_d,{show:!1}),Ph='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Sd="bold "+Ph,yd=1.5,kp={show:!0,scale:"x",stroke:Mh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Sd,side:2,grid:Ch,ticks:vd,border:Md,font:Ph,lineGap:yd,rotate:0},lS="Value",cS="Time",Gp={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function uS(n,e,t,i,r){return e.map(s=>s==null?"":wh(s))}function hS(n,e,t,i,r,s,o){let a=[],l=Hr.get(r)||0;t=o?t:Wt(ac(t,r),l);for(let c=t;c<=i;c=Wt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function mh(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Sr:td,u=hn(c(t));r=Js(l,u),l==10&&(r=ds[Vn(r,ds)]);let h=t,f=r*l;l==10&&(f=ds[Vn(f,ds)]);do a.push(h),h=h+r,l==10&&!Hr.has(h)&&(h=Wt(h,Hr.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=ds[Vn(f,ds)]));while(h<=i);return a}function fS(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?mh(n,e,ji(l,t),i,r):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?mh(n,e,ji(l,-i),-t,r):[l]).reverse().map(f=>-f).concat(u,c)}var bd=/./,pS=/[12357]/,dS=/[125]/,zp=/1/,gh=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function mS(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?bd:l(7,o)-u>=c?pS:l(5,o)-u>=c?dS:zp;if(h==zp){let f=Si(l(1,o)-u);if(f<c)return gh(e.slice().reverse(),a.distr,h,Tn(c/f)).reverse()}return gh(e,a.distr,h,1)}function gS(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Si(l(1,o)-l(2,o));return c<a?gh(e.slice().reverse(),3,bd,Tn(a/c)).reverse():e}function xS(n,e,t,i){return i==null?Sh:e==null?"":wh(e)}var Hp={show:!0,scale:"y",stroke:Mh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Sd,side:3,grid:Ch,ticks:vd,border:Md,font:Ph,lineGap:yd,rotate:0};function _S(n,e){let t=3+(n||1)*2;return Wt(t*e,3)}function vS(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Si(o-s),l=n.series[e],c=a/(l.points.space*Ft);return i[1]-i[0]<=c}var Vp={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},Ed=(n,e,t,i,r)=>r,Wp={show:!0,auto:!0,sorted:0,gaps:Ed,alpha:1,facets:[gi({},Vp,{scale:"x"}),gi({},Vp,{scale:"y"})]},Xp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ed,alpha:1,points:{show:vS,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function MS(n,e,t,i,r){return t/10}var wd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},SS=gi({},wd,{time:!1,ori:1}),qp={};function Td(n,e){let t=qp[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(i,r,s,o,a,l,c)}},n!=null&&(qp[n]=t)),t}var eo=1,xh=2;function _s(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],u=i==2?o[r.facets[0].scale]:o[n.series[0].scale],h=i==2?o[r.facets[1].scale]:o[r.scale],f=a.left,p=a.top,m=a.width,M=a.height,d=n.valToPosH,g=n.valToPosV;return u.ori==0?t(r,l,c,u,h,d,g,f,p,m,M,uc,io,fc,Rd,Pd):t(r,l,c,u,h,g,d,p,f,M,m,hc,no,Ih,Cd,Ld)}function Lh(n,e){let t=0,i=0,r=Dt(n.bands,Th);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function yS(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function yr(n,e,t,i,r,s){return _s(n,e,(o,a,l,c,u,h,f,p,m,M,d)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?io:no,S,C;v==1?(S=t,C=i):(S=i,C=t);let A=g(h(a[S],c,M,p)),x=g(f(l[S],u,d,m)),E=g(h(a[C],c,M,p)),B=g(f(s==1?u.max:u.min,u,d,m)),D=new Path2D(r);return T(D,E,B),T(D,A,B),T(D,A,x),D})}function cc(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?fc:Ih,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+s),l=f[1]}}let c=t+r-l,u=10;c>0&&a(o,l,i-u/2,c,i+s+u)}return o}function bS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Dh(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let h=c,f=c;if(r==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=s(n[h]),m=f==h?p:s(n[f]),M=h-r;p=o<=0&&M>=0&&M<l?s(n[M]):p;let g=f+r;m=o>=0&&g>=0&&g<l?s(n[g]):m,m>=p&&a.push([p,m])}return a}function Yp(n){return n==0?nd:n==1?Mi:e=>ps(e,n)}function Ad(n){let e=n==0?uc:hc,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?i(r,s,o,a,l):(c=Wn(c,a/2,l/2),u=Wn(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var uc=(n,e,t)=>{n.moveTo(e,t)},hc=(n,e,t)=>{n.moveTo(t,e)},io=(n,e,t)=>{n.lineTo(e,t)},no=(n,e,t)=>{n.lineTo(t,e)},fc=Ad(0),Ih=Ad(1),Rd=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Cd=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Pd=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Ld=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function Dd(n){return(e,t,i,r,s)=>_s(e,t,(o,a,l,c,u,h,f,p,m,M,d)=>{let{pxRound:g,points:v}=o,T,S;c.ori==0?(T=uc,S=Rd):(T=hc,S=Cd);let C=Wt(v.width*Ft,3),A=(v.size-v.width)/2*Ft,x=Wt(A*2,3),E=new Path2D,B=new Path2D,{left:D,top:L,width:G,height:W}=e.bbox;fc(B,D-x,L-x,G+x*2,W+x*2);let I=H=>{if(l[H]!=null){let q=g(h(a[H],c,M,p)),z=g(f(l[H],u,d,m));T(E,q+A,z),S(E,q,z,A,0,tc*2)}};if(s)s.forEach(I);else for(let H=i;H<=r;H++)I(H);return{stroke:C>0?E:null,fill:E,clip:B,flags:eo|xh}})}function Id(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var ES=Id(io),wS=Id(no);function Ud(n){let e=Dt(n?.alignGaps,0);return(t,i,r,s)=>_s(t,i,(o,a,l,c,u,h,f,p,m,M,d)=>{[r,s]=sc(l,r,s);let g=o.pxRound,v=W=>g(h(W,c,M,p)),T=W=>g(f(W,u,d,m)),S,C;c.ori==0?(S=io,C=ES):(S=no,C=wS);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:eo},E=x.stroke,B=!1;if(s-r>=M*4){let W=ue=>t.posToVal(ue,c.key,!0),I=null,H=null,q,z,ce,$=v(a[A==1?r:s]),Q=v(a[r]),ee=v(a[s]),pe=W(A==1?Q+1:ee-1);for(let ue=A==1?r:s;ue>=r&&ue<=s;ue+=A){let j=a[ue],ve=(A==1?j<pe:j>pe)?$:v(j),De=l[ue];ve==$?De!=null?(z=De,I==null?(S(E,ve,T(z)),q=I=H=z):z<I?I=z:z>H&&(H=z)):De===null&&(B=!0):(I!=null&&C(E,$,T(I),T(H),T(q),T(z)),De!=null?(z=De,S(E,ve,T(z)),I=H=q=z):(I=H=null,De===null&&(B=!0)),$=ve,pe=W($+A))}I!=null&&I!=H&&ce!=$&&C(E,$,T(I),T(H),T(q),T(z))}else for(let W=A==1?r:s;W>=r&&W<=s;W+=A){let I=l[W];I===null?B=!0:I!=null&&S(E,v(a[W]),T(I))}let[L,G]=Lh(t,i);if(o.fill!=null||L!=0){let W=x.fill=new Path2D(E),I=o.fillTo(t,i,o.min,o.max,L),H=T(I),q=v(a[r]),z=v(a[s]);A==-1&&([z,q]=[q,z]),S(W,z,H),S(W,q,H)}if(!o.spanGaps){let W=[];B&&W.push(...Dh(a,l,r,s,A,v,e)),x.gaps=W=o.gaps(t,i,r,s,W),x.clip=cc(W,c.ori,p,m,M,d)}return G!=0&&(x.band=G==2?[yr(t,i,r,s,E,-1),yr(t,i,r,s,E,1)]:yr(t,i,r,s,E,G)),x})}function TS(n){let e=Dt(n.align,1),t=Dt(n.ascDesc,!1),i=Dt(n.alignGaps,0),r=Dt(n.extend,!1);return(s,o,a,l)=>_s(s,o,(c,u,h,f,p,m,M,d,g,v,T)=>{[a,l]=sc(h,a,l);let S=c.pxRound,{left:C,width:A}=s.bbox,x=Q=>S(m(Q,f,v,d)),E=Q=>S(M(Q,p,T,g)),B=f.ori==0?io:no,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:eo},L=D.stroke,G=f.dir*(f.ori==0?1:-1),W=E(h[G==1?a:l]),I=x(u[G==1?a:l]),H=I,q=I;r&&e==-1&&(q=C,B(L,q,W)),B(L,I,W);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let ee=h[Q];if(ee==null)continue;let pe=x(u[Q]),ue=E(ee);e==1?B(L,pe,W):B(L,H,ue),B(L,pe,ue),W=ue,H=pe}let z=H;r&&e==1&&(z=C+A,B(L,z,W));let[ce,$]=Lh(s,o);if(c.fill!=null||ce!=0){let Q=D.fill=new Path2D(L),ee=c.fillTo(s,o,c.min,c.max,ce),pe=E(ee);B(Q,z,pe),B(Q,q,pe)}if(!c.spanGaps){let Q=[];Q.push(...Dh(u,h,a,l,G,x,i));let ee=c.width*Ft/2,pe=t||e==1?ee:-ee,ue=t||e==-1?-ee:ee;Q.forEach(j=>{j[0]+=pe,j[1]+=ue}),D.gaps=Q=c.gaps(s,o,a,l,Q),D.clip=cc(Q,f.ori,d,g,v,T)}return $!=0&&(D.band=$==2?[yr(s,o,a,l,L,-1),yr(s,o,a,l,L,1)]:yr(s,o,a,l,L,$)),D})}function Kp(n,e,t,i,r,s,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Si(n[l]-n[a]);u<c&&(c=u,o=Si(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function AS(n){n=n||Ma;let e=Dt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=Ct(r),o=1-e[0],a=Dt(e[1],Vt),l=Dt(e[2],1),c=Dt(n.disp,Ma),u=Dt(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,m,M,d)=>_s(p,m,(g,v,T,S,C,A,x,E,B,D,L)=>{let G=g.pxRound,W=t,I=i*Ft,H=a*Ft,q=l*Ft,z,ce;S.ori==0?[z,ce]=s(p,m):[ce,z]=s(p,m);let $=S.dir*(S.ori==0?1:-1),Q=S.ori==0?fc:Ih,ee=S.ori==0?u:(ye,qe,ht,we,Nt,$e,it)=>{u(ye,qe,ht,Nt,we,it,$e)},pe=Dt(p.bands,Th).find(ye=>ye.series[0]==m),ue=pe!=null?pe.dir:0,j=g.fillTo(p,m,g.min,g.max,ue),xe=G(x(j,C,L,B)),ve,De,Ee,He=D,ot=G(g.width*Ft),Je=!1,at=null,rt=null,se=null,Me=null;h!=null&&(ot==0||f!=null)&&(Je=!0,at=h.values(p,m,M,d),rt=new Map,new Set(at).forEach(ye=>{ye!=null&&rt.set(ye,new Path2D)}),ot>0&&(se=f.values(p,m,M,d),Me=new Map,new Set(se).forEach(ye=>{ye!=null&&Me.set(ye,new Path2D)})));let{x0:_e,size:Be}=c;if(_e!=null&&Be!=null){W=1,v=_e.values(p,m,M,d),_e.unit==2&&(v=v.map(ht=>p.posToVal(E+ht*D,S.key,!0)));let ye=Be.values(p,m,M,d);Be.unit==2?De=ye[0]*D:De=A(ye[0],S,D,E)-A(0,S,D,E),He=Kp(v,T,A,S,D,E,He),Ee=He-De+I}else He=Kp(v,T,A,S,D,E,He),Ee=He*o+I,De=He-Ee;Ee<1&&(Ee=0),ot>=De/2&&(ot=0),Ee<5&&(G=nd);let Ie=Ee>0,nt=He-Ee-(Ie?ot:0);De=G(dh(nt,q,H)),ve=(W==0?De/2:W==$?0:De)-W*$*((W==0?I/2:0)+(Ie?ot/2:0));let ke={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gt=Je?null:new Path2D,pt=null;if(pe!=null)pt=p.data[pe.series[1]];else{let{y0:ye,y1:qe}=c;ye!=null&&qe!=null&&(T=qe.values(p,m,M,d),pt=ye.values(p,m,M,d))}let St=z*De,F=ce*De;for(let ye=$==1?M:d;ye>=M&&ye<=d;ye+=$){let qe=T[ye];if(qe==null)continue;if(pt!=null){let X=pt[ye]??0;if(qe-X==0)continue;xe=x(X,C,L,B)}let ht=S.distr!=2||c!=null?v[ye]:ye,we=A(ht,S,D,E),Nt=x(Dt(qe,j),C,L,B),$e=G(we-ve),it=G(ji(Nt,xe)),R=G(Wn(Nt,xe)),y=it-R;if(qe!=null){let X=qe<0?F:St,fe=qe<0?St:F;Je?(ot>0&&se[ye]!=null&&Q(Me.get(se[ye]),$e,R+hn(ot/2),De,ji(0,y-ot),X,fe),at[ye]!=null&&Q(rt.get(at[ye]),$e,R+hn(ot/2),De,ji(0,y-ot),X,fe)):Q(gt,$e,R+hn(ot/2),De,ji(0,y-ot),X,fe),ee(p,m,ye,$e-ot/2,R,De+ot,y)}}return ot>0?ke.stroke=Je?Me:gt:Je||(ke._fill=g.width==0?g._fill:g._stroke??g._fill,ke.width=0),ke.fill=Je?rt:gt,ke})}function RS(n,e){let t=Dt(e?.alignGaps,0);return(i,r,s,o)=>_s(i,r,(a,l,c,u,h,f,p,m,M,d,g)=>{[s,o]=sc(c,s,o);let v=a.pxRound,T=z=>v(f(z,u,d,m)),S=z=>v(p(z,h,g,M)),C,A,x;u.ori==0?(C=uc,x=io,A=Pd):(C=hc,x=no,A=Ld);let E=u.dir*(u.ori==0?1:-1),B=T(l[E==1?s:o]),D=B,L=[],G=[];for(let z=E==1?s:o;z>=s&&z<=o;z+=E)if(c[z]!=null){let $=l[z],Q=T($);L.push(D=Q),G.push(S(c[z]))}let W={stroke:n(L,G,C,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:eo},I=W.stroke,[H,q]=Lh(i,r);if(a.fill!=null||H!=0){let z=W.fill=new Path2D(I),ce=a.fillTo(i,r,a.min,a.max,H),$=S(ce);x(z,D,$),x(z,B,$)}if(!a.spanGaps){let z=[];z.push(...Dh(l,c,s,o,E,T,t)),W.gaps=z=a.gaps(i,r,s,o,z),W.clip=cc(z,u.ori,m,M,d,g)}return q!=0&&(W.band=q==2?[yr(i,r,s,o,I,-1),yr(i,r,s,o,I,1)]:yr(i,r,s,o,I,q)),W})}function CS(n){return RS(PS,n)}function PS(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var _h=new Set;function $p(){for(let n of _h)n.syncRect(!0)}to&&(gs(uM,Zs,$p),gs(hM,Zs,$p,!0),gs(ic,Zs,()=>{Bi.pxRatio=Ft}));var LS=Ud(),DS=Dd();function Zp(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>vh(s,o,e,t))}function IS(n,e){return n.map((t,i)=>i==0?{}:gi({},e,t))}function vh(n,e,t,i){return gi({},e==0?t:i,n)}function Fd(n,e,t){return e==null?Qs:[e,t]}var US=Fd;function FS(n,e,t){return e==null?Qs:nc(e,t,Eh,!0)}function Nd(n,e,t,i){return e==null?Qs:oc(e,t,n.scales[i].log,!1)}var NS=Nd;function Od(n,e,t,i){return e==null?Qs:bh(e,t,n.scales[i].log,!1)}var OS=Od;function BS(n,e,t,i,r){let s=ji(Rp(n),Rp(e)),o=e-n,a=Vn(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Hr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Jp(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Mi((t=+r)*Ft))+"px"),[n,e,t]}function kS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Wt(e[2]*Ft,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Bi(n,e,t){let i={mode:Dt(n.mode,1)},r=i.mode;function s(_,b,P,U){let V=b.valToPct(_);return U+P*(b.dir==-1?1-V:V)}function o(_,b,P,U){let V=b.valToPct(_);return U+P*(b.dir==-1?V:1-V)}function a(_,b,P,U){return b.ori==0?s(_,b,P,U):o(_,b,P,U)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=wn(qv);if(n.id!=null&&(c.id=n.id),un(c,n.class),n.title){let _=wn($v,c);_.textContent=n.title}let u=Hn("canvas"),h=i.ctx=u.getContext("2d"),f=wn(Zv,c);gs("click",f,_=>{_.target===m&&(qt!=Gs||Zt!=zs)&&Ni.click(i,_)},!0);let p=i.under=wn(Jv,f);f.appendChild(u);let m=i.over=wn(Qv,f);n=js(n);let M=+Dt(n.pxAlign,1),d=Yp(M);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let g=n.ms||.001,v=i.series=r==1?Zp(n.series||[],Gp,Xp,!1):IS(n.series||[null],Wp),T=i.axes=Zp(n.axes||[],kp,Hp,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=Ct(_.fill||null),_.dir=Dt(_.dir,-1)});let A=r==2?v[1].facets[0].scale:v[0].scale,x={axes:_r,series:wt},E=(n.drawOrder||["axes","series"]).map(_=>x[_]);function B(_){let b=_.distr==3?P=>Sr(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>oh(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let U=b(P),{_min:V,_max:Z}=_,ae=Z-V;return(U-V)/ae}}function D(_){let b=S[_];if(b==null){let P=(n.scales||Ma)[_]||Ma;if(P.from!=null){D(P.from);let U=gi({},S[P.from],P,{key:_});U.valToPct=B(U),S[_]=U}else{b=S[_]=gi({},_==A?wd:SS,P),b.key=_;let U=b.time,V=b.range,Z=zr(V);if((_!=A||r==2&&!U)&&(Z&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?wp:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?wp:{mode:1,hard:V[1],soft:V[1]}},Z=!1),!Z&&lc(V))){let ae=V;V=(de,Ae,Ge)=>Ae==null?Qs:nc(Ae,Ge,ae)}b.range=Ct(V||(U?US:_==A?b.distr==3?NS:b.distr==4?OS:Fd:b.distr==3?Nd:b.distr==4?Od:FS)),b.auto=Ct(Z?!1:b.auto),b.clamp=Ct(b.clamp||MS),b._min=b._max=null,b.valToPct=B(b)}}}D("x"),D("y"),r==1&&v.forEach(_=>{D(_.scale)}),T.forEach(_=>{D(_.scale)});for(let _ in n.scales)D(_);let L=S[A],G=L.distr,W,I;L.ori==0?(un(c,Yv),W=s,I=o):(un(c,Kv),W=o,I=s);let H={};for(let _ in S){let b=S[_];(b.min!=null||b.max!=null)&&(H[_]={min:b.min,max:b.max},b.min=b.max=null)}let q=n.tzDate||(_=>new Date(Mi(_/g))),z=n.fmtDate||Ah,ce=g==1?YM(q):ZM(q),$=Np(q,Fp(g==1?qM:$M,z)),Q=Bp(q,Op(QM,z)),ee=[],pe=i.legend=gi({},tS,n.legend),ue=i.cursor=gi({},aS,{drag:{y:r==2}},n.cursor),j=pe.show,xe=ue.show,ve=pe.markers;pe.idxs=ee,ve.width=Ct(ve.width),ve.dash=Ct(ve.dash),ve.stroke=Ct(ve.stroke),ve.fill=Ct(ve.fill);let De,Ee,He,ot=[],Je=[],at,rt=!1,se={};if(pe.live){let _=v[1]?v[1].values:null;rt=_!=null,at=rt?_(i,1,0):{_:0};for(let b in at)se[b]=Sh}if(j)if(De=Hn("table",rM,c),He=Hn("tbody",null,De),pe.mount(i,De),rt){Ee=Hn("thead",null,De,He);let _=Hn("tr",null,Ee);Hn("th",null,_);for(var Me in at)Hn("th",fp,_).textContent=Me}else un(De,oM),pe.live&&un(De,sM);let _e={show:!0},Be={show:!1};function Ie(_,b){if(b==0&&(rt||!pe.live||r==2))return Qs;let P=[],U=Hn("tr",aM,He,He.childNodes[b]);un(U,_.class),_.show||un(U,ms);let V=Hn("th",null,U);if(ve.show){let de=wn(lM,V);if(b>0){let Ae=ve.width(i,b);Ae&&(de.style.border=Ae+"px "+ve.dash(i,b)+" "+ve.stroke(i,b)),de.style.background=ve.fill(i,b)}}let Z=wn(fp,V);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,b>0&&(ve.show||(Z.style.color=_.width>0?ve.stroke(i,b):ve.fill(i,b)),ke("click",V,de=>{if(ue._lock)return;ct(de);let Ae=v.indexOf(_);if((de.ctrlKey||de.metaKey)!=pe.isolate){let Ge=v.some((ze,We)=>We>0&&We!=Ae&&ze.show);v.forEach((ze,We)=>{We>0&&nr(We,Ge?We==Ae?_e:Be:_e,!0,mi.setSeries)})}else nr(Ae,{show:!_.show},!0,mi.setSeries)},!1),ut&&ke(gp,V,de=>{ue._lock||(ct(de),nr(v.indexOf(_),Vs,!0,mi.setSeries))},!1));for(var ae in at){let de=Hn("td",cM,U);de.textContent="--",P.push(de)}return[U,P]}let nt=new Map;function ke(_,b,P,U=!0){let V=nt.get(b)||{},Z=ue.bind[_](i,b,P,U);Z&&(gs(_,b,V[_]=Z),nt.set(b,V))}function gt(_,b,P){let U=nt.get(b)||{};for(let V in U)(_==null||V==_)&&(ph(V,b,U[V]),delete U[V]);_==null&&nt.delete(b)}let pt=0,St=0,F=0,ye=0,qe=0,ht=0,we=qe,Nt=ht,$e=F,it=ye,R=0,y=0,X=0,fe=0;i.bbox={};let oe=!1,be=!1,Te=!1,te=!1,ne=!1,ge=!1;function N(_,b,P){(P||_!=i.width||b!=i.height)&&re(_,b),yt(!1),Te=!0,be=!0,zi()}function re(_,b){i.width=pt=F=_,i.height=St=ye=b,qe=ht=0,Re(),Qe();let P=i.bbox;R=P.left=ps(qe*Ft,.5),y=P.top=ps(ht*Ft,.5),X=P.width=ps(F*Ft,.5),fe=P.height=ps(ye*Ft,.5)}let ie=3;function Ce(){let _=!1,b=0;for(;!_;){b++;let P=Os(b),U=ir(b);_=b==ie||P&&U,_||(re(i.width,i.height),be=!0)}}function Se({width:_,height:b}){N(_,b)}i.setSize=Se;function Re(){let _=!1,b=!1,P=!1,U=!1;T.forEach((V,Z)=>{if(V.show&&V._show){let{side:ae,_size:de}=V,Ae=ae%2,Ge=V.label!=null?V.labelSize:0,ze=de+Ge;ze>0&&(Ae?(F-=ze,ae==3?(qe+=ze,U=!0):P=!0):(ye-=ze,ae==0?(ht+=ze,_=!0):b=!0))}}),er[0]=_,er[1]=P,er[2]=b,er[3]=U,F-=On[1]+On[3],qe+=On[3],ye-=On[2]+On[0],ht+=On[0]}function Qe(){let _=qe+F,b=ht+ye,P=qe,U=ht;function V(Z,ae){switch(Z){case 1:return _+=ae,_-ae;case 2:return b+=ae,b-ae;case 3:return P-=ae,P+ae;case 0:return U-=ae,U+ae}}T.forEach((Z,ae)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=V(de,Z._size),Z.label!=null&&(Z._lpos=V(de,Z.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let P=_.prox=Ct(_.prox),U=_.bias??=0;ue.dataIdx=(V,Z,ae,de)=>{if(Z==0)return ae;let Ae=ae,Ge=P(V,Z,ae,de)??Vt,ze=Ge>=0&&Ge<Vt,We=L.ori==0?F:ye,dt=ue.left,Ut=e[0],Lt=e[Z];if(b.has(Lt[ae])){Ae=null;let Tt=null,lt=null,je;if(U==0||U==-1)for(je=ae;Tt==null&&je-- >0;)b.has(Lt[je])||(Tt=je);if(U==0||U==1)for(je=ae;lt==null&&je++<Lt.length;)b.has(Lt[je])||(lt=je);if(Tt!=null||lt!=null)if(ze){let Kt=Tt==null?-1/0:W(Ut[Tt],L,We,0),si=lt==null?1/0:W(Ut[lt],L,We,0),Pi=dt-Kt,Ht=si-dt;Pi<=Ht?Pi<=Ge&&(Ae=Tt):Ht<=Ge&&(Ae=lt)}else Ae=lt==null?Tt:Tt==null?lt:ae-Tt<=lt-ae?Tt:lt}else ze&&Si(dt-W(Ut[ae],L,We,0))>Ge&&(Ae=null);return Ae}}let ct=_=>{ue.event=_};ue.idxs=ee,ue._lock=!1;let he=ue.points;he.show=Ct(he.show),he.size=Ct(he.size),he.stroke=Ct(he.stroke),he.width=Ct(he.width),he.fill=Ct(he.fill);let Ye=i.focus=gi({},n.focus||{alpha:.3},ue.focus),ut=Ye.prox>=0,Ue=ut&&he.one,Mt=[],Xt=[],Yi=[];function na(_,b){let P=he.show(i,b);if(P instanceof HTMLElement)return un(P,nM),un(P,_.class),lr(P,-10,-10,F,ye),m.insertBefore(P,Mt[b]),P}function Us(_,b){if(r==1||b>0){let P=r==1&&S[_.scale].time,U=_.value;_.value=P?Lp(U)?Bp(q,Op(U,z)):U||Q:U||xS,_.label=_.label||(P?cS:lS)}if(Ue||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||LS||SM,_.fillTo=Ct(_.fillTo||yS),_.pxAlign=+Dt(_.pxAlign,M),_.pxRound=Yp(_.pxAlign),_.stroke=Ct(_.stroke||null),_.fill=Ct(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=_S(ji(1,_.width),1),U=_.points=gi({},{size:P,width:ji(1,P*.2),stroke:_.stroke,space:P*2,paths:DS,_stroke:null,_fill:null},_.points);U.show=Ct(U.show),U.filter=Ct(U.filter),U.fill=Ct(U.fill),U.stroke=Ct(U.stroke),U.paths=Ct(U.paths),U.pxAlign=_.pxAlign}if(j){let P=Ie(_,b);ot.splice(b,0,P[0]),Je.splice(b,0,P[1]),pe.values.push(null)}if(xe){ee.splice(b,0,null);let P=null;Ue?b==0&&(P=na(_,b)):b>0&&(P=na(_,b)),Mt.splice(b,0,P),Xt.splice(b,0,0),Yi.splice(b,0,0)}Ci("addSeries",b)}function Vu(_,b){b=b??v.length,_=r==1?vh(_,b,Gp,Xp):vh(_,b,{},Wp),v.splice(b,0,_),Us(v[b],b)}i.addSeries=Vu;function Ll(_){if(v.splice(_,1),j){pe.values.splice(_,1),Je.splice(_,1);let b=ot.splice(_,1)[0];gt(null,b.firstChild),b.remove()}xe&&(ee.splice(_,1),Mt.splice(_,1)[0].remove(),Xt.splice(_,1),Yi.splice(_,1)),Ci("delSeries",_)}i.delSeries=Ll;let er=[!1,!1,!1,!1];function mr(_,b){if(_._show=_.show,_.show){let P=_.side%2,U=S[_.scale];U==null&&(_.scale=P?v[1].scale:A,U=S[_.scale]);let V=U.time;_.size=Ct(_.size),_.space=Ct(_.space),_.rotate=Ct(_.rotate),zr(_.incrs)&&_.incrs.forEach(ae=>{!Hr.has(ae)&&Hr.set(ae,od(ae))}),_.incrs=Ct(_.incrs||(U.distr==2?VM:V?g==1?XM:KM:ds)),_.splits=Ct(_.splits||(V&&U.distr==1?ce:U.distr==3?mh:U.distr==4?fS:hS)),_.stroke=Ct(_.stroke),_.grid.stroke=Ct(_.grid.stroke),_.ticks.stroke=Ct(_.ticks.stroke),_.border.stroke=Ct(_.border.stroke);let Z=_.values;_.values=zr(Z)&&!zr(Z[0])?Ct(Z):V?zr(Z)?Np(q,Fp(Z,z)):Lp(Z)?JM(q,Z):Z||$:Z||uS,_.filter=Ct(_.filter||(U.distr>=3&&U.log==10?mS:U.distr==3&&U.log==2?gS:rd)),_.font=Jp(_.font),_.labelFont=Jp(_.labelFont),_._size=_.size(i,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(er[b]=!0,_._el=wn(jv,f))}}function gr(_,b,P,U){let[V,Z,ae,de]=P,Ae=b%2,Ge=0;return Ae==0&&(de||Z)&&(Ge=b==0&&!V||b==2&&!ae?Mi(kp.size/3):0),Ae==1&&(V||ae)&&(Ge=b==1&&!Z||b==3&&!de?Mi(Hp.size/2):0),Ge}let ra=i.padding=(n.padding||[gr,gr,gr,gr]).map(_=>Ct(Dt(_,gr))),On=i._padding=ra.map((_,b)=>_(i,b,er,0)),ni,li=null,ci=null,tr=r==1?v[0].idxs:null,rn=null,Dr=!1;function sa(_,b){if(e=_??[],i.data=i._data=e,r==2){ni=0;for(let P=1;P<v.length;P++)ni+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),rn=e[0],ni=rn.length;let P=e;if(G==2){P=e.slice();let U=P[0]=Array(ni);for(let V=0;V<ni;V++)U[V]=V}i._data=e=P}if(yt(!0),Ci("setData"),G==2&&(Te=!0),b!==!1){let P=L;P.auto(i,Dr)?oa():Fr(A,P.min,P.max),te=te||ue.left>=0,ge=!0,zi()}}i.setData=sa;function oa(){Dr=!0;let _,b;r==1&&(ni>0?(li=tr[0]=0,ci=tr[1]=ni-1,_=e[0][li],b=e[0][ci],G==2?(_=li,b=ci):_==b&&(G==3?[_,b]=oc(_,_,L.log,!1):G==4?[_,b]=bh(_,_,L.log,!1):L.time?b=_+Mi(86400/g):[_,b]=nc(_,b,Eh,!0))):(li=tr[0]=_=null,ci=tr[1]=b=null)),Fr(A,_,b)}let Fs,Ir,Ns,w,k,J,Y,K,Pe,Fe;function Le(_,b,P,U,V,Z){_??=dp,P??=Th,U??="butt",V??=dp,Z??="round",_!=Fs&&(h.strokeStyle=Fs=_),V!=Ir&&(h.fillStyle=Ir=V),b!=Ns&&(h.lineWidth=Ns=b),Z!=k&&(h.lineJoin=k=Z),U!=J&&(h.lineCap=J=U),P!=w&&h.setLineDash(w=P)}function Oe(_,b,P,U){b!=Ir&&(h.fillStyle=Ir=b),_!=Y&&(h.font=Y=_),P!=K&&(h.textAlign=K=P),U!=Pe&&(h.textBaseline=Pe=U)}function Ze(_,b,P,U,V=0){if(U.length>0&&_.auto(i,Dr)&&(b==null||b.min==null)){let Z=Dt(li,0),ae=Dt(ci,U.length-1),de=P.min==null?mM(U,Z,ae,V,_.distr==3):[P.min,P.max];_.min=Wn(_.min,P.min=de[0]),_.max=ji(_.max,P.max=de[1])}}let ft={min:null,max:null};function Et(){for(let U in S){let V=S[U];H[U]==null&&(V.min==null||H[A]!=null&&V.auto(i,Dr))&&(H[U]=ft)}for(let U in S){let V=S[U];H[U]==null&&V.from!=null&&H[V.from]!=null&&(H[U]=ft)}H[A]!=null&&yt(!0);let _={};for(let U in H){let V=H[U];if(V!=null){let Z=_[U]=js(S[U],EM);if(V.min!=null)gi(Z,V);else if(U!=A||r==2)if(ni==0&&Z.from==null){let ae=Z.range(i,null,null,U);Z.min=ae[0],Z.max=ae[1]}else Z.min=Vt,Z.max=-Vt}}if(ni>0){v.forEach((U,V)=>{if(r==1){let Z=U.scale,ae=H[Z];if(ae==null)return;let de=_[Z];if(V==0){let Ae=de.range(i,de.min,de.max,Z);de.min=Ae[0],de.max=Ae[1],li=Vn(de.min,e[0]),ci=Vn(de.max,e[0]),ci-li>1&&(e[0][li]<de.min&&li++,e[0][ci]>de.max&&ci--),U.min=rn[li],U.max=rn[ci]}else U.show&&U.auto&&Ze(de,ae,U,e[V],U.sorted);U.idxs[0]=li,U.idxs[1]=ci}else if(V>0&&U.show&&U.auto){let[Z,ae]=U.facets,de=Z.scale,Ae=ae.scale,[Ge,ze]=e[V],We=_[de],dt=_[Ae];We!=null&&Ze(We,H[de],Z,Ge,Z.sorted),dt!=null&&Ze(dt,H[Ae],ae,ze,ae.sorted),U.min=ae.min,U.max=ae.max}});for(let U in _){let V=_[U],Z=H[U];if(V.from==null&&(Z==null||Z.min==null)){let ae=V.range(i,V.min==Vt?null:V.min,V.max==-Vt?null:V.max,U);V.min=ae[0],V.max=ae[1]}}}for(let U in _){let V=_[U];if(V.from!=null){let Z=_[V.from];if(Z.min==null)V.min=V.max=null;else{let ae=V.range(i,Z.min,Z.max,U);V.min=ae[0],V.max=ae[1]}}}let b={},P=!1;for(let U in _){let V=_[U],Z=S[U];if(Z.min!=V.min||Z.max!=V.max){Z.min=V.min,Z.max=V.max;let ae=Z.distr;Z._min=ae==3?Sr(Z.min):ae==4?oh(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?Sr(Z.max):ae==4?oh(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,b[U]=P=!0}}if(P){v.forEach((U,V)=>{r==2?V>0&&b.y&&(U._paths=null):b[U.scale]&&(U._paths=null)});for(let U in b)Te=!0,Ci("setScale",U);xe&&ue.left>=0&&(te=ge=!0)}for(let U in H)H[U]=null}function Ke(_){let b=dh(li-1,0,ni-1),P=dh(ci+1,0,ni-1);for(;_[b]==null&&b>0;)b--;for(;_[P]==null&&P<ni-1;)P++;return[b,P]}function wt(){if(ni>0){let _=v.some(b=>b._focus)&&Fe!=Ye.alpha;_&&(h.globalAlpha=Fe=Ye.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(jt(P,!1),jt(P,!0),b._paths==null)){let U=Fe;Fe!=b.alpha&&(h.globalAlpha=Fe=b.alpha);let V=r==2?[0,e[P][0].length-1]:Ke(e[P]);b._paths=b.paths(i,P,V[0],V[1]),Fe!=U&&(h.globalAlpha=Fe=U)}}),v.forEach((b,P)=>{if(P>0&&b.show){let U=Fe;Fe!=b.alpha&&(h.globalAlpha=Fe=b.alpha),b._paths!=null&&Bt(P,!1);{let V=b._paths!=null?b._paths.gaps:null,Z=b.points.show(i,P,li,ci,V),ae=b.points.filter(i,P,Z,V);(Z||ae)&&(b.points._paths=b.points.paths(i,P,li,ci,ae),Bt(P,!0))}Fe!=U&&(h.globalAlpha=Fe=U),Ci("drawSeries",P)}}),_&&(h.globalAlpha=Fe=1)}}function jt(_,b){let P=b?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Bt(_,b){let P=b?v[_].points:v[_],{stroke:U,fill:V,clip:Z,flags:ae,_stroke:de=P._stroke,_fill:Ae=P._fill,_width:Ge=P.width}=P._paths;Ge=Wt(Ge*Ft,3);let ze=null,We=Ge%2/2;b&&Ae==null&&(Ae=Ge>0?"#fff":de);let dt=P.pxAlign==1&&We>0;if(dt&&h.translate(We,We),!b){let Ut=R-Ge/2,Lt=y-Ge/2,Tt=X+Ge,lt=fe+Ge;ze=new Path2D,ze.rect(Ut,Lt,Tt,lt)}b?Ve(de,Ge,P.dash,P.cap,Ae,U,V,ae,Z):kt(_,de,Ge,P.dash,P.cap,Ae,U,V,ae,ze,Z),dt&&h.translate(-We,-We)}function kt(_,b,P,U,V,Z,ae,de,Ae,Ge,ze){let We=!1;Ae!=0&&C.forEach((dt,Ut)=>{if(dt.series[0]==_){let Lt=v[dt.series[1]],Tt=e[dt.series[1]],lt=(Lt._paths||Ma).band;zr(lt)&&(lt=dt.dir==1?lt[0]:lt[1]);let je,Kt=null;Lt.show&&lt&&xM(Tt,li,ci)?(Kt=dt.fill(i,Ut)||Z,je=Lt._paths.clip):lt=null,Ve(b,P,U,V,Kt,ae,de,Ae,Ge,ze,je,lt),We=!0}}),We||Ve(b,P,U,V,Z,ae,de,Ae,Ge,ze)}let vi=eo|xh;function Ve(_,b,P,U,V,Z,ae,de,Ae,Ge,ze,We){Le(_,b,P,U,V),(Ae||Ge||We)&&(h.save(),Ae&&h.clip(Ae),Ge&&h.clip(Ge)),We?(de&vi)==vi?(h.clip(We),ze&&h.clip(ze),Rt(V,ae),fi(_,Z,b)):de&xh?(Rt(V,ae),h.clip(We),fi(_,Z,b)):de&eo&&(h.save(),h.clip(We),ze&&h.clip(ze),Rt(V,ae),h.restore(),fi(_,Z,b)):(Rt(V,ae),fi(_,Z,b)),(Ae||Ge||We)&&h.restore()}function fi(_,b,P){P>0&&(b instanceof Map?b.forEach((U,V)=>{h.strokeStyle=Fs=V,h.stroke(U)}):b!=null&&_&&h.stroke(b))}function Rt(_,b){b instanceof Map?b.forEach((P,U)=>{h.fillStyle=Ir=U,h.fill(P)}):b!=null&&_&&h.fill(b)}function xr(_,b,P,U){let V=T[_],Z;if(U<=0)Z=[0,0];else{let ae=V._space=V.space(i,_,b,P,U),de=V._incrs=V.incrs(i,_,b,P,U,ae);Z=BS(b,P,de,U,ae)}return V._found=Z}function pi(_,b,P,U,V,Z,ae,de,Ae,Ge){let ze=ae%2/2;M==1&&h.translate(ze,ze),Le(de,ae,Ae,Ge,de),h.beginPath();let We,dt,Ut,Lt,Tt=V+(U==0||U==3?-Z:Z);P==0?(dt=V,Lt=Tt):(We=V,Ut=Tt);for(let lt=0;lt<_.length;lt++)b[lt]!=null&&(P==0?We=Ut=_[lt]:dt=Lt=_[lt],h.moveTo(We,dt),h.lineTo(Ut,Lt));h.stroke(),M==1&&h.translate(-ze,-ze)}function Os(_){let b=!0;return T.forEach((P,U)=>{if(!P.show)return;let V=S[P.scale];if(V.min==null){P._show&&(b=!1,P._show=!1,yt(!1));return}else P._show||(b=!1,P._show=!0,yt(!1));let Z=P.side,ae=Z%2,{min:de,max:Ae}=V,[Ge,ze]=xr(U,de,Ae,ae==0?F:ye);if(ze==0)return;let We=V.distr==2,dt=P._splits=P.splits(i,U,de,Ae,Ge,ze,We),Ut=V.distr==2?dt.map(je=>rn[je]):dt,Lt=V.distr==2?rn[dt[1]]-rn[dt[0]]:Ge,Tt=P._values=P.values(i,P.filter(i,Ut,U,ze,Lt),U,ze,Lt);P._rotate=Z==2?P.rotate(i,Tt,U,ze):0;let lt=P._size;P._size=Tn(P.size(i,Tt,U,_)),lt!=null&&P._size!=lt&&(b=!1)}),b}function ir(_){let b=!0;return ra.forEach((P,U)=>{let V=P(i,U,er,_);V!=On[U]&&(b=!1),On[U]=V}),b}function _r(){for(let _=0;_<T.length;_++){let b=T[_];if(!b.show||!b._show)continue;let P=b.side,U=P%2,V,Z,ae=b.stroke(i,_),de=P==0||P==3?-1:1,[Ae,Ge]=b._found;if(b.label!=null){let Zi=b.labelGap*de,an=Mi((b._lpos+Zi)*Ft);Oe(b.labelFont[0],ae,"center",P==2?"top":pp),h.save(),U==1?(V=Z=0,h.translate(an,Mi(y+fe/2)),h.rotate((P==3?-tc:tc)/2)):(V=Mi(R+X/2),Z=an);let us=id(b.label)?b.label(i,_,Ae,Ge):b.label;h.fillText(us,V,Z),h.restore()}if(Ge==0)continue;let ze=S[b.scale],We=U==0?X:fe,dt=U==0?R:y,Ut=b._splits,Lt=ze.distr==2?Ut.map(Zi=>rn[Zi]):Ut,Tt=ze.distr==2?rn[Ut[1]]-rn[Ut[0]]:Ae,lt=b.ticks,je=b.border,Kt=lt.show?lt.size:0,si=Mi(Kt*Ft),Pi=Mi((b.alignTo==2?b._size-Kt-b.gap:b.gap)*Ft),Ht=b._rotate*-tc/180,oi=d(b._pos*Ft),sn=(si+Pi)*de,$i=oi+sn;Z=U==0?$i:0,V=U==1?$i:0;let bn=b.font[0],Bn=b.align==1?Ks:b.align==2?nh:Ht>0?Ks:Ht<0?nh:U==0?"center":P==3?nh:Ks,sr=Ht||U==1?"middle":P==2?"top":pp;Oe(bn,ae,Bn,sr);let on=b.font[1]*b.lineGap,En=Ut.map(Zi=>d(a(Zi,ze,We,dt))),kn=b._values;for(let Zi=0;Zi<kn.length;Zi++){let an=kn[Zi];if(an!=null){U==0?V=En[Zi]:Z=En[Zi],an=""+an;let us=an.indexOf(`
`)==-1?[an]:an.split(/\n/gm);for(let Ji=0;Ji<us.length;Ji++){let Jf=us[Ji];Ht?(h.save(),h.translate(V,Z+Ji*on),h.rotate(Ht),h.fillText(Jf,0,0),h.restore()):h.fillText(Jf,V,Z+Ji*on)}}}lt.show&&pi(En,lt.filter(i,Lt,_,Ge,Tt),U,P,oi,si,Wt(lt.width*Ft,3),lt.stroke(i,_),lt.dash,lt.cap);let or=b.grid;or.show&&pi(En,or.filter(i,Lt,_,Ge,Tt),U,U==0?2:1,U==0?y:R,U==0?fe:X,Wt(or.width*Ft,3),or.stroke(i,_),or.dash,or.cap),je.show&&pi([oi],[1],U==0?1:0,U==0?1:2,U==1?y:R,U==1?fe:X,Wt(je.width*Ft,3),je.stroke(i,_),je.dash,je.cap)}Ci("drawAxes")}function yt(_){v.forEach((b,P)=>{P>0&&(b._paths=null,_&&(r==1?(b.min=null,b.max=null):b.facets.forEach(U=>{U.min=null,U.max=null})))})}let ri=!1,Ki=!1,Gt=[];function di(){Ki=!1;for(let _=0;_<Gt.length;_++)Ci(...Gt[_]);Gt.length=0}function zi(){ri||(LM(If),ri=!0)}function Dl(_,b=!1){ri=!0,Ki=b,_(i),If(),b&&Gt.length>0&&queueMicrotask(di)}i.batch=Dl;function If(){if(oe&&(Et(),oe=!1),Te&&(Ce(),Te=!1),be){if($t(p,Ks,qe),$t(p,"top",ht),$t(p,ga,F),$t(p,xa,ye),$t(m,Ks,qe),$t(m,"top",ht),$t(m,ga,F),$t(m,xa,ye),$t(f,ga,pt),$t(f,xa,St),u.width=Mi(pt*Ft),u.height=Mi(St*Ft),T.forEach(({_el:_,_show:b,_size:P,_pos:U,side:V})=>{if(_!=null)if(b){let Z=V===3||V===0?P:0,ae=V%2==1;$t(_,ae?"left":"top",U-Z),$t(_,ae?"width":"height",P),$t(_,ae?"top":"left",ae?ht:qe),$t(_,ae?"height":"width",ae?ye:F),fh(_,ms)}else un(_,ms)}),Fs=Ir=Ns=k=J=Y=K=Pe=w=null,Fe=1,ca(!0),qe!=we||ht!=Nt||F!=$e||ye!=it){yt(!1);let _=F/$e,b=ye/it;if(xe&&!te&&ue.left>=0){ue.left*=_,ue.top*=b,Bs&&lr(Bs,Mi(ue.left),0,F,ye),ks&&lr(ks,0,Mi(ue.top),F,ye);for(let P=0;P<Mt.length;P++){let U=Mt[P];U!=null&&(Xt[P]*=_,Yi[P]*=b,lr(U,Tn(Xt[P]),Tn(Yi[P]),F,ye))}}if(Yt.show&&!ne&&Yt.left>=0&&Yt.width>0){Yt.left*=_,Yt.width*=_,Yt.top*=b,Yt.height*=b;for(let P in $u)$t(Hs,P,Yt[P])}we=qe,Nt=ht,$e=F,it=ye}Ci("setSize"),be=!1}pt>0&&St>0&&(h.clearRect(0,0,u.width,u.height),Ci("drawClear"),E.forEach(_=>_()),Ci("draw")),Yt.show&&ne&&(Il(Yt),ne=!1),xe&&te&&(cs(null,!0,!1),te=!1),pe.show&&pe.live&&ge&&(Yu(),ge=!1),l||(l=!0,i.status=1,Ci("ready")),Dr=!1,ri=!1}i.redraw=(_,b)=>{Te=b||!1,_!==!1?Fr(A,L.min,L.max):zi()};function Wu(_,b){let P=S[_];if(P.from==null){if(ni==0){let U=P.range(i,b.min,b.max,_);b.min=U[0],b.max=U[1]}if(b.min>b.max){let U=b.min;b.min=b.max,b.max=U}if(ni>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==A&&P.distr==2&&ni>0&&(b.min=Vn(b.min,e[0]),b.max=Vn(b.max,e[0]),b.min==b.max&&b.max++),H[_]=b,oe=!0,zi()}}i.setScale=Wu;let Xu,qu,Bs,ks,Uf,Ff,Gs,zs,Nf,Of,qt,Zt,Ur=!1,Ni=ue.drag,Ai=Ni.x,Ri=Ni.y;xe&&(ue.x&&(Xu=wn(tM,m)),ue.y&&(qu=wn(iM,m)),L.ori==0?(Bs=Xu,ks=qu):(Bs=qu,ks=Xu),qt=ue.left,Zt=ue.top);let Yt=i.select=gi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Hs=Yt.show?wn(eM,Yt.over?m:p):null;function Il(_,b){if(Yt.show){for(let P in _)Yt[P]=_[P],P in $u&&$t(Hs,P,_[P]);b!==!1&&Ci("setSelect")}}i.setSelect=Il;function cv(_){if(v[_].show)j&&fh(ot[_],ms);else if(j&&un(ot[_],ms),xe){let P=Ue?Mt[0]:Mt[_];P!=null&&lr(P,-10,-10,F,ye)}}function Fr(_,b,P){Wu(_,{min:b,max:P})}function nr(_,b,P,U){b.focus!=null&&dv(_),b.show!=null&&v.forEach((V,Z)=>{Z>0&&(_==Z||_==null)&&(V.show=b.show,cv(Z),r==2?(Fr(V.facets[0].scale,null,null),Fr(V.facets[1].scale,null,null)):Fr(V.scale,null,null),zi())}),P!==!1&&Ci("setSeries",_,b),U&&ua("setSeries",i,_,b)}i.setSeries=nr;function uv(_,b){gi(C[_],b)}function hv(_,b){_.fill=Ct(_.fill||null),_.dir=Dt(_.dir,-1),b=b??C.length,C.splice(b,0,_)}function fv(_){_==null?C.length=0:C.splice(_,1)}i.addBand=hv,i.setBand=uv,i.delBand=fv;function pv(_,b){v[_].alpha=b,xe&&Mt[_]!=null&&(Mt[_].style.opacity=b),j&&ot[_]&&(ot[_].style.opacity=b)}let vr,Nr,ls,Vs={focus:!0};function dv(_){if(_!=ls){let b=_==null,P=Ye.alpha!=1;v.forEach((U,V)=>{if(r==1||V>0){let Z=b||V==0||V==_;U._focus=b?null:Z,P&&pv(V,Z?1:Ye.alpha)}}),ls=_,P&&zi()}}j&&ut&&ke(xp,De,_=>{ue._lock||(ct(_),ls!=null&&nr(null,Vs,!0,mi.setSeries))});function rr(_,b,P){let U=S[b];P&&(_=_/Ft-(U.ori==1?ht:qe));let V=F;U.ori==1&&(V=ye,_=V-_),U.dir==-1&&(_=V-_);let Z=U._min,ae=U._max,de=_/V,Ae=Z+(ae-Z)*de,Ge=U.distr;return Ge==3?Js(10,Ae):Ge==4?vM(Ae,U.asinh):Ge==100?U.bwd(Ae):Ae}function mv(_,b){let P=rr(_,A,b);return Vn(P,e[0],li,ci)}i.valToIdx=_=>Vn(_,e[0]),i.posToIdx=mv,i.posToVal=rr,i.valToPos=(_,b,P)=>S[b].ori==0?s(_,S[b],P?X:F,P?R:0):o(_,S[b],P?fe:ye,P?y:0),i.setCursor=(_,b,P)=>{qt=_.left,Zt=_.top,cs(null,b,P)};function Bf(_,b){$t(Hs,Ks,Yt.left=_),$t(Hs,ga,Yt.width=b)}function kf(_,b){$t(Hs,"top",Yt.top=_),$t(Hs,xa,Yt.height=b)}let aa=L.ori==0?Bf:kf,la=L.ori==1?Bf:kf;function gv(){if(j&&pe.live)for(let _=r==2?1:0;_<v.length;_++){if(_==0&&rt)continue;let b=pe.values[_],P=0;for(let U in b)Je[_][P++].firstChild.nodeValue=b[U]}}function Yu(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((P,U)=>{ee[U]=P}):bM(_.idx)||ee.fill(_.idx),pe.idx=ee[0]),j&&pe.live){for(let P=0;P<v.length;P++)(P>0||r==1&&!rt)&&xv(P,ee[P]);gv()}ge=!1,b!==!1&&Ci("setLegend")}i.setLegend=Yu;function xv(_,b){let P=v[_],U=_==0&&G==2?rn:e[_],V;rt?V=P.values(i,_,b)??se:(V=P.value(i,b==null?null:U[b],_,b),V=V==null?se:{_:V}),pe.values[_]=V}function cs(_,b,P){Nf=qt,Of=Zt,[qt,Zt]=ue.move(i,qt,Zt),ue.left=qt,ue.top=Zt,xe&&(Bs&&lr(Bs,Mi(qt),0,F,ye),ks&&lr(ks,0,Mi(Zt),F,ye));let U,V=li>ci;vr=Vt,Nr=null;let Z=L.ori==0?F:ye,ae=L.ori==1?F:ye;if(qt<0||ni==0||V){U=ue.idx=null;for(let de=0;de<v.length;de++){let Ae=Mt[de];Ae!=null&&lr(Ae,-10,-10,F,ye)}ut&&nr(null,Vs,!0,_==null&&mi.setSeries),pe.live&&(ee.fill(U),ge=!0)}else{let de,Ae,Ge;r==1&&(de=L.ori==0?qt:Zt,Ae=rr(de,A),U=ue.idx=Vn(Ae,e[0],li,ci),Ge=W(e[0][U],L,Z,0));let ze=-10,We=-10,dt=0,Ut=0,Lt=!0,Tt="",lt="";for(let je=r==2?1:0;je<v.length;je++){let Kt=v[je],si=ee[je],Pi=si==null?null:r==1?e[je][si]:e[je][1][si],Ht=ue.dataIdx(i,je,U,Ae),oi=Ht==null?null:r==1?e[je][Ht]:e[je][1][Ht];if(ge=ge||oi!=Pi||Ht!=si,ee[je]=Ht,je>0&&Kt.show){let sn=Ht==null?-10:Ht==U?Ge:W(r==1?e[0][Ht]:e[je][0][Ht],L,Z,0),$i=oi==null?-10:I(oi,r==1?S[Kt.scale]:S[Kt.facets[1].scale],ae,0);if(ut&&oi!=null){let bn=L.ori==1?qt:Zt,Bn=Si(Ye.dist(i,je,Ht,$i,bn));if(Bn<vr){let sr=Ye.bias;if(sr!=0){let on=rr(bn,Kt.scale),En=oi>=0?1:-1,kn=on>=0?1:-1;kn==En&&(kn==1?sr==1?oi>=on:oi<=on:sr==1?oi<=on:oi>=on)&&(vr=Bn,Nr=je)}else vr=Bn,Nr=je}}if(ge||Ue){let bn,Bn;L.ori==0?(bn=sn,Bn=$i):(bn=$i,Bn=sn);let sr,on,En,kn,or,Zi,an=!0,us=he.bbox;if(us!=null){an=!1;let Ji=us(i,je);En=Ji.left,kn=Ji.top,sr=Ji.width,on=Ji.height}else En=bn,kn=Bn,sr=on=he.size(i,je);if(Zi=he.fill(i,je),or=he.stroke(i,je),Ue)je==Nr&&vr<=Ye.prox&&(ze=En,We=kn,dt=sr,Ut=on,Lt=an,Tt=Zi,lt=or);else{let Ji=Mt[je];Ji!=null&&(Xt[je]=En,Yi[je]=kn,Ep(Ji,sr,on,an),yp(Ji,Zi,or),lr(Ji,Tn(En),Tn(kn),F,ye))}}}}if(Ue){let je=Ye.prox,Kt=ls==null?vr<=je:vr>je||Nr!=ls;if(ge||Kt){let si=Mt[0];si!=null&&(Xt[0]=ze,Yi[0]=We,Ep(si,dt,Ut,Lt),yp(si,Tt,lt),lr(si,Tn(ze),Tn(We),F,ye))}}}if(Yt.show&&Ur)if(_!=null){let[de,Ae]=mi.scales,[Ge,ze]=mi.match,[We,dt]=_.cursor.sync.scales,Ut=_.cursor.drag;if(Ai=Ut._x,Ri=Ut._y,Ai||Ri){let{left:Lt,top:Tt,width:lt,height:je}=_.select,Kt=_.scales[We].ori,si=_.posToVal,Pi,Ht,oi,sn,$i,bn=de!=null&&Ge(de,We),Bn=Ae!=null&&ze(Ae,dt);bn&&Ai?(Kt==0?(Pi=Lt,Ht=lt):(Pi=Tt,Ht=je),oi=S[de],sn=W(si(Pi,We),oi,Z,0),$i=W(si(Pi+Ht,We),oi,Z,0),aa(Wn(sn,$i),Si($i-sn))):aa(0,Z),Bn&&Ri?(Kt==1?(Pi=Lt,Ht=lt):(Pi=Tt,Ht=je),oi=S[Ae],sn=I(si(Pi,dt),oi,ae,0),$i=I(si(Pi+Ht,dt),oi,ae,0),la(Wn(sn,$i),Si($i-sn))):la(0,ae)}else Zu()}else{let de=Si(Nf-Uf),Ae=Si(Of-Ff);if(L.ori==1){let dt=de;de=Ae,Ae=dt}Ai=Ni.x&&de>=Ni.dist,Ri=Ni.y&&Ae>=Ni.dist;let Ge=Ni.uni;Ge!=null?Ai&&Ri&&(Ai=de>=Ge,Ri=Ae>=Ge,!Ai&&!Ri&&(Ae>de?Ri=!0:Ai=!0)):Ni.x&&Ni.y&&(Ai||Ri)&&(Ai=Ri=!0);let ze,We;Ai&&(L.ori==0?(ze=Gs,We=qt):(ze=zs,We=Zt),aa(Wn(ze,We),Si(We-ze)),Ri||la(0,ae)),Ri&&(L.ori==1?(ze=Gs,We=qt):(ze=zs,We=Zt),la(Wn(ze,We),Si(We-ze)),Ai||aa(0,Z)),!Ai&&!Ri&&(aa(0,0),la(0,0))}if(Ni._x=Ai,Ni._y=Ri,_==null){if(P){if(Zf!=null){let[de,Ae]=mi.scales;mi.values[0]=de!=null?rr(L.ori==0?qt:Zt,de):null,mi.values[1]=Ae!=null?rr(L.ori==1?qt:Zt,Ae):null}ua(rh,i,qt,Zt,F,ye,U)}if(ut){let de=P&&mi.setSeries,Ae=Ye.prox;ls==null?vr<=Ae&&nr(Nr,Vs,!0,de):vr>Ae?nr(null,Vs,!0,de):Nr!=ls&&nr(Nr,Vs,!0,de)}}ge&&(pe.idx=U,Yu()),b!==!1&&Ci("setCursor")}let Or=null;Object.defineProperty(i,"rect",{get(){return Or==null&&ca(!1),Or}});function ca(_=!1){_?Or=null:(Or=m.getBoundingClientRect(),Ci("syncRect",Or))}function Gf(_,b,P,U,V,Z,ae){ue._lock||Ur&&_!=null&&_.movementX==0&&_.movementY==0||(Ku(_,b,P,U,V,Z,ae,!1,_!=null),_!=null?cs(null,!0,!0):cs(b,!0,!1))}function Ku(_,b,P,U,V,Z,ae,de,Ae){if(Or==null&&ca(!1),ct(_),_!=null)P=_.clientX-Or.left,U=_.clientY-Or.top;else{if(P<0||U<0){qt=-10,Zt=-10;return}let[Ge,ze]=mi.scales,We=b.cursor.sync,[dt,Ut]=We.values,[Lt,Tt]=We.scales,[lt,je]=mi.match,Kt=b.axes[0].side%2==1,si=L.ori==0?F:ye,Pi=L.ori==1?F:ye,Ht=Kt?Z:V,oi=Kt?V:Z,sn=Kt?U:P,$i=Kt?P:U;if(Lt!=null?P=lt(Ge,Lt)?a(dt,S[Ge],si,0):-10:P=si*(sn/Ht),Tt!=null?U=je(ze,Tt)?a(Ut,S[ze],Pi,0):-10:U=Pi*($i/oi),L.ori==1){let bn=P;P=U,U=bn}}Ae&&(b==null||b.cursor.event.type==rh)&&((P<=1||P>=F-1)&&(P=ps(P,F)),(U<=1||U>=ye-1)&&(U=ps(U,ye))),de?(Uf=P,Ff=U,[Gs,zs]=ue.move(i,P,U)):(qt=P,Zt=U)}let $u={width:0,height:0,left:0,top:0};function Zu(){Il($u,!1)}let zf,Hf,Vf,Wf;function Xf(_,b,P,U,V,Z,ae){Ur=!0,Ai=Ri=Ni._x=Ni._y=!1,Ku(_,b,P,U,V,Z,ae,!0,!1),_!=null&&(ke(sh,uh,qf,!1),ua(mp,i,Gs,zs,F,ye,null));let{left:de,top:Ae,width:Ge,height:ze}=Yt;zf=de,Hf=Ae,Vf=Ge,Wf=ze}function qf(_,b,P,U,V,Z,ae){Ur=Ni._x=Ni._y=!1,Ku(_,b,P,U,V,Z,ae,!1,!0);let{left:de,top:Ae,width:Ge,height:ze}=Yt,We=Ge>0||ze>0,dt=zf!=de||Hf!=Ae||Vf!=Ge||Wf!=ze;if(We&&dt&&Il(Yt),Ni.setScale&&We&&dt){let Ut=de,Lt=Ge,Tt=Ae,lt=ze;if(L.ori==1&&(Ut=Ae,Lt=ze,Tt=de,lt=Ge),Ai&&Fr(A,rr(Ut,A),rr(Ut+Lt,A)),Ri)for(let je in S){let Kt=S[je];je!=A&&Kt.from==null&&Kt.min!=Vt&&Fr(je,rr(Tt+lt,je),rr(Tt,je))}Zu()}else ue.lock&&(ue._lock=!ue._lock,cs(b,!0,_!=null));_!=null&&(gt(sh,uh),ua(sh,i,qt,Zt,F,ye,null))}function _v(_,b,P,U,V,Z,ae){if(ue._lock)return;ct(_);let de=Ur;if(Ur){let Ae=!0,Ge=!0,ze=10,We,dt;L.ori==0?(We=Ai,dt=Ri):(We=Ri,dt=Ai),We&&dt&&(Ae=qt<=ze||qt>=F-ze,Ge=Zt<=ze||Zt>=ye-ze),We&&Ae&&(qt=qt<Gs?0:F),dt&&Ge&&(Zt=Zt<zs?0:ye),cs(null,!0,!0),Ur=!1}qt=-10,Zt=-10,ee.fill(null),cs(null,!0,!0),de&&(Ur=de)}function Yf(_,b,P,U,V,Z,ae){ue._lock||(ct(_),oa(),Zu(),_!=null&&ua(_p,i,qt,Zt,F,ye,null))}function Kf(){T.forEach(kS),N(i.width,i.height,!0)}gs(ic,Zs,Kf);let Ws={};Ws.mousedown=Xf,Ws.mousemove=Gf,Ws.mouseup=qf,Ws.dblclick=Yf,Ws.setSeries=(_,b,P,U)=>{let V=mi.match[2];P=V(i,b,P),P!=-1&&nr(P,U,!0,!1)},xe&&(ke(mp,m,Xf),ke(rh,m,Gf),ke(gp,m,_=>{ct(_),ca(!1)}),ke(xp,m,_v),ke(_p,m,Yf),_h.add(i),i.syncRect=ca);let Ul=i.hooks=n.hooks||{};function Ci(_,b,P){Ki?Gt.push([_,b,P]):_ in Ul&&Ul[_].forEach(U=>{U.call(null,i,b,P)})}(n.plugins||[]).forEach(_=>{for(let b in _.hooks)Ul[b]=(Ul[b]||[]).concat(_.hooks[b])});let $f=(_,b,P)=>P,mi=gi({key:null,setSeries:!1,filters:{pub:Cp,sub:Cp},scales:[A,v[1]?v[1].scale:null],match:[Pp,Pp,$f],values:[null,null]},ue.sync);mi.match.length==2&&mi.match.push($f),ue.sync=mi;let Zf=mi.key,Ju=Td(Zf);function ua(_,b,P,U,V,Z,ae){mi.filters.pub(_,b,P,U,V,Z,ae)&&Ju.pub(_,b,P,U,V,Z,ae)}Ju.sub(i);function vv(_,b,P,U,V,Z,ae){mi.filters.sub(_,b,P,U,V,Z,ae)&&Ws[_](null,b,P,U,V,Z,ae)}i.pub=vv;function Mv(){Ju.unsub(i),_h.delete(i),nt.clear(),ph(ic,Zs,Kf),c.remove(),De?.remove(),Ci("destroy")}i.destroy=Mv;function Qu(){Ci("init",n,e),sa(e||n.data,!1),H[A]?Wu(A,H[A]):oa(),ne=Yt.show&&(Yt.width>0||Yt.height>0),te=ge=!0,N(n.width,n.height)}return v.forEach(Us),T.forEach(mr),t?t instanceof HTMLElement?(t.appendChild(c),Qu()):t(i,Qu):Qu(),i}Bi.assign=gi;Bi.fmtNum=wh;Bi.rangeNum=nc;Bi.rangeLog=oc;Bi.rangeAsinh=bh;Bi.orient=_s;Bi.pxRatio=Ft;Bi.join=PM;Bi.fmtDate=Ah,Bi.tzDate=zM;Bi.sync=Td;{Bi.addGap=bS,Bi.clipGaps=cc;let n=Bi.paths={points:Dd};n.linear=Ud,n.stepped=TS,n.bars=AS,n.spline=CS}var GS=6e5,[zS,HS]=[60,600];function Bd(n,e,t){let i=GS/Math.max(1,n.balls.length*e.length),r=Math.round(Math.min(HS,Math.max(zS,i/2))),s=[...new Set(e.flatMap(l=>l.events.map(c=>c.at)))].filter(l=>l>0&&l<t).sort((l,c)=>l-c),o=Math.max(1,Math.ceil(2*s.length/Math.max(1,i-r))),a=[];for(let l=0;l<=r;l+=1)a.push([t*l/r,0]);for(let l=0;l<s.length;l+=o)a.push([s[l],1],[s[l],0]);return a.sort((l,c)=>l[0]-c[0]||c[1]-l[1]),{at:Float64Array.from(a,l=>l[0]),near:Uint8Array.from(a,l=>l[1])}}function kd(n,e,t){let i=t.at.length,r=new Float64Array(i),s=new Float64Array(i),o=new Float64Array(i),a=Gn();n.balls.forEach((c,u)=>{let h=c.inertia/(n.R*n.R);for(let f=0;f<i;f+=1){let p=t.at[f],m=t.near[f]===1;if((m?p>e.leaves[u]:p>=e.leaves[u])||!e.paths[u]?.at(p,a,m))continue;let M=Uh(a.velocity);r[f]+=M,s[f]+=1,o[f]+=(c.mass*M+h*Uh(a.spin))/2}});let l=r.map((c,u)=>s[u]>0?Math.sqrt(c/s[u]):0);return{rms:Fh(l,t,e.facts.end),energy:Fh(o,t,e.facts.end)}}function Gd(n,e,t){let i=Gn(),r=Float64Array.from(t.at,(s,o)=>{let a=t.near[o]===1;return!(a?s>n.leaves[e]:s>=n.leaves[e])&&n.paths[e]?.at(s,i,a)?Math.sqrt(Uh(i.velocity)):NaN});return Fh(r,t,n.facts.end)}function Uh(n){return n[0]*n[0]+n[1]*n[1]+n[2]*n[2]}function Fh(n,e,t){let i=Math.fround(t)*1.000001,r=NaN;return n.map((s,o)=>e.at[o]<=i?(r=s,s):r===0?0:NaN)}function ro(n,e,t){let i=0,r=n.length;for(;i<r;){let a=i+r>>1;n[a]<=t?i=a+1:r=a}if(i===0)return NaN;let s=e[i-1]??NaN;if(i===n.length||t===n[i-1])return s;let o=e[i]??NaN;return s+(t-n[i-1])/(n[i]-n[i-1])*(o-s)}var zd=210,Hd=10,Vd=11,so=class{constructor(e,...t){this.facts=e;this.data=me("details",{},me("summary",{},"Data"),me("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":`${e.title}, data`},this.table)),this.data.addEventListener("toggle",()=>this.fill());let i=e.unit.length>Hd?[me("span",{class:"rp-unit"},`in ${e.unit}`)]:[];this.element=me("figure",{class:"rp-chart"},me("figcaption",{},me("b",{},e.title),...t,...i),this.host,this.values,this.data)}facts;element;host=me("div",{class:"rp-plot"});values=me("p",{class:"rp-values"});numbers=[];at=me("span",{});table=me("table",{});data;nowLine=me("div",{class:"rp-now-line"});future=me("div",{class:"rp-future"});plot=null;content={at:new Float64Array(0),lines:[]};time=0;told=-1/0;width=0;show(e){this.content=e;let t=e.lines.map(i=>me("span",{class:"rp-value"},Ys(i.run),me("span",{})));this.numbers.splice(0,1/0,...t.map(i=>i.lastElementChild)),this.values.replaceChildren(this.at,...t),this.build()}resize(e){Math.abs(e-this.width)>=1&&(this.width=e,this.plot?(this.plot.setSize({width:e,height:zd}),this.go(this.time,!1)):this.build())}go(e,t){this.time=e;let{plot:i}=this;if(!i)return;let r=i.valToPos(e,"x");this.nowLine.style.transform=`translateX(${r.toFixed(2)}px)`,this.facts.growing&&(this.future.style.left=`${r.toFixed(2)}px`);let s=performance.now();(!t||s-this.told>200)&&(this.told=s,this.tell())}build(){this.plot?.destroy(),this.plot=null;let{content:e,facts:t,host:i,width:r}=this;if(r<40||e.at.length===0)return;let s=getComputedStyle(this.element),o=t.unit.length>Hd,[a,l]=[s.getPropertyValue("--rp-soft").trim(),s.getPropertyValue("--rp-rule").trim()],c=`12px ${s.fontFamily}`,u={stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1,size:5},font:c,labelFont:c,labelSize:18},h=e.lines.flatMap(v=>Array.from(v.values).filter(T=>T>0)),f=h.reduce((v,T)=>Math.min(v,T),1/0),p=h.reduce((v,T)=>Math.max(v,T),0),m=(v,T)=>10**(T?Math.ceil(Math.log10(v)+.05):Math.floor(Math.log10(v))),M=t.log?[m(Math.max(f,1e-17),!1),m(Math.max(p,1e-16),!0)]:[0,p*1.16||1],d={width:r,height:zd,padding:[8,14,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5}},select:{show:!1,left:0,top:0,width:0,height:0},scales:{x:{time:!1,range:[0,t.end||1]},y:t.log?{distr:3,log:10,range:M}:{range:M}},axes:[{...u,label:`time, ${t.timeUnit}`,size:34},{...u,label:o?t.axis:`${t.axis}, ${t.unit}`,size:50,...t.log?{splits:()=>VS(M),filter:(v,T)=>T}:{},values:(v,T)=>T.map(S=>t.log?`1e${Math.round(Math.log10(S))}`.replace(/^1e0$/,"1"):fs(S))}],series:[{},...e.lines.map(v=>({label:v.label,stroke:eh(v.run),width:1.8,dash:ln(v.run).dash,points:{show:!1}}))],hooks:{draw:[v=>this.marks(v),v=>this.labels(v)]}},g=e.lines.map(v=>Array.from(v.values,T=>Number.isFinite(T)&&(!t.log||T>0)?T:null));this.plot=new Bi(d,[Array.from(e.at),...g],i),this.plot.over.append(this.nowLine),t.growing&&this.plot.over.append(this.future),this.hold(this.plot),this.go(this.time,!1),this.fill()}destroy(){this.plot?.destroy(),this.plot=null}hold(e){let{over:t}=e,i=r=>{let s=t.getBoundingClientRect();this.facts.seek(e.posToVal(r.clientX-s.left,"x"))};t.addEventListener("pointerdown",r=>{t.setPointerCapture(r.pointerId),i(r)}),t.addEventListener("pointermove",r=>{(r.buttons&1)!==0&&i(r)})}marks(e){let{ctx:t,bbox:i}=e,r=getComputedStyle(this.element),s=(o,a,l,c)=>{let u=e.valToPos(o,"x",!0);t.save(),t.strokeStyle=a,t.fillStyle=a,t.lineWidth=devicePixelRatio,t.setLineDash(l.map(p=>p*devicePixelRatio)),t.beginPath(),t.moveTo(u,i.top),t.lineTo(u,i.top+i.height),t.stroke(),t.font=`${10.5*devicePixelRatio}px ${r.fontFamily}`;let h=t.measureText(c).width,f=u+h+8*devicePixelRatio<i.left+i.width;t.textAlign=f?"left":"right",t.fillText(c,u+(f?4:-4)*devicePixelRatio,i.top+10*devicePixelRatio),t.restore()};this.facts.partings.length>0&&s(this.facts.partings[0],r.getPropertyValue("--rp-bad").trim(),[],"first divergence");for(let o of this.facts.partings.slice(1))s(o,r.getPropertyValue("--rp-bad").trim(),[2,3],"");this.facts.horizon!==null&&s(this.facts.horizon,r.getPropertyValue("--rp-soft").trim(),[6,3],"horizon")}labels(e){let{ctx:t,bbox:i}=e,{lines:r,at:s}=this.content;if(r.length<2)return;let o=devicePixelRatio,a=12*o;t.save(),t.font=`600 ${11*o}px ${getComputedStyle(this.element).fontFamily}`,t.textAlign="center";let l=[];r.forEach((c,u)=>{let h=t.measureText(c.label).width+6*o,f={x:0,y:0,room:0};for(let p=i.left+h/2+2*o;p<i.left+i.width-h/2;p+=i.width/60){let m=[-.5,-.25,0,.25,.5].map(x=>{let E=e.posToVal((p+x*h-i.left)/o,"x");return r.map(B=>e.valToPos(ro(s,B.values,E),"y",!0))}),M=m.map(x=>x[u]);if(!M.every(Number.isFinite))continue;let d=Math.min(...M)-5*o,g=d-a/3,v=m.flatMap(x=>x.filter((E,B)=>B!==u&&Number.isFinite(E))).map(x=>Math.abs(x-g)-a/2),T=m.flatMap(x=>x.filter((E,B)=>B!==u&&Number.isFinite(E)).map(E=>Math.abs(E-x[u])-9*o)),S=l.map(x=>Math.max(Math.abs(x.x-p)-(x.w+h)/2,Math.abs(x.y-d)-a)),C=Math.max(...M)-Math.min(...M),A=Math.min(40*o,d-a-i.top-12*o,...v,...T,...S)-.6*C;A>f.room&&(f={x:p,y:d,room:A})}f.room>0&&(t.fillStyle=eh(c.run),t.fillText(c.label,f.x,f.y),l.push({x:f.x,y:f.y,w:h}))}),t.restore()}tell(){let{content:e,facts:t}=this;zn(this.at,e.lines.length>0?`${Oi(this.time,t.end)} ${t.timeUnit}:`:""),e.lines.forEach((i,r)=>zn(this.numbers[r],`${i.label} ${fs(ro(e.at,i.values,this.time))}`)),this.data.open&&this.fill()}fill(){if(!this.data.open)return;let{content:e,facts:t}=this,i=(a,l)=>me("tr",{},me("th",{scope:"row",class:"r"},l),...e.lines.map(c=>me("td",{class:"r"},fs(ro(e.at,c.values,a))))),r=Array.from({length:Vd},(a,l)=>t.end*l/(Vd-1)),s=t.growing?r.filter(a=>a<=this.time):r,o=me("tr",{},me("th",{scope:"col",class:"r"},`time, ${t.timeUnit}`),...e.lines.map(a=>me("th",{scope:"col",class:"r"},a.label)));this.table.replaceChildren(me("caption",{},`${t.axis}, ${t.unit}`),me("thead",{},o),me("tbody",{},i(this.time,`now: ${Oi(this.time,t.end)}`),...s.map(a=>i(a,Oi(a,t.end)))))}};function VS([n,e]){let[t,i]=[Math.round(Math.log10(n)),Math.round(Math.log10(e))],r=Math.max(1,Math.ceil((i-t)/6)),s=[];for(let o=Math.ceil(t/r)*r;o<=i;o+=r)s.push(10**o);return s}var pc=class{constructor(e,t,i){this.stage=e;let{data:r,runs:s,end:o}=e,a=r.scene.time_unit,l=(c,u,h,f=!1)=>({title:c,axis:u,unit:h,log:f,growing:i,timeUnit:a,end:o,partings:r.partings.map(p=>p.time),horizon:r.horizon,seek:p=>t.seek(p)});this.ball=me("select",{"aria-label":"Speed of"},me("option",{value:-1},"all balls, rms"),...r.balls.map((c,u)=>me("option",{value:u},c.id==="cue"?"the cue ball":`ball ${c.id}`))),this.ball.addEventListener("change",()=>t.follow(Number(this.ball.value))),this.speed=new so(l("Speed","speed",`${r.scene.length_unit}/${a}`),me("label",{}," of ",this.ball)),this.energy=new so(l("Kinetic energy","energy","E0")),this.divergence=r.divergence.some(c=>c.points.some(([,u])=>u>0))?new so(l("Distance between engines, worst ball","distance","R",!0)):null,this.when=Bd(r,s,o),this.initial=WS(e);for(let c of this.charts())this.element.append(c.element);this.sizes=new ResizeObserver(c=>{for(let u of c)this.charts().find(h=>h.element===u.target)?.resize(Math.floor(u.contentRect.width))}),this.charts().forEach(c=>this.sizes.observe(c.element)),this.dark.addEventListener("change",this.recolour)}stage;element=me("div",{class:"rp-plots"});speed;energy;divergence;ball;when;made=new Map;sizes;dark=matchMedia("(prefers-color-scheme: dark)");choice=null;initial;choose(e){let t=this.choice,i=t!==null&&t.ball===e.ball&&t.solid===e.solid&&t.shown.join()===e.shown.join();if(this.choice={...e,shown:[...e.shown]},i)return;this.ball.value=String(e.ball);let{stage:r,when:s}=this,{data:o}=r,a=r.runs.filter(c=>e.shown[c.index]||c.index===e.solid),l=c=>({at:s.at,lines:a.map(u=>({label:u.facts.label,run:u.index,values:c(u.index)}))});this.speed.show(l(c=>(e.ball<0?this.curves(c).rms:Gd(r.runs[c],e.ball,s)).map(u=>u*o.R))),this.energy.show(l(c=>this.curves(c).energy.map(u=>this.initial>0?u/this.initial:u))),this.divergence?.show(this.pairs(e))}go(e,t){for(let i of this.charts())i.go(e,t)}destroy(){this.dark.removeEventListener("change",this.recolour),this.sizes.disconnect();for(let e of this.charts())e.destroy()}recolour=()=>this.charts().forEach(e=>e.build());charts(){return[this.speed,this.energy,...this.divergence?[this.divergence]:[]]}curves(e){let t=this.made.get(e);return t||(t=kd(this.stage.data,this.stage.runs[e],this.when),this.made.set(e,t)),t}pairs(e){let{data:t}=this.stage,i=a=>e.shown[a]||a===e.solid,r=t.divergence.filter(a=>i(a.run)&&i(a.against)),s=Float64Array.from(new Set(r.flatMap(a=>a.points.map(([l])=>l)))).sort(),o=r.map(a=>{let[l,c]=[a.points.map(([f])=>f),a.points.map(([,f])=>f)],u=t.runs[a.run].label,h=t.runs[a.against];return{label:h.reference?u:`${u} to ${h.label}`,run:a.run,values:Float64Array.from(s,f=>f<=l[l.length-1]?ro(l,c,f):NaN)}});return{at:s,lines:o}}};function WS(n){let{data:e,runs:t}=n,i=Gn();for(let r of t)if(r.paths.every(s=>s.count>0))return e.balls.reduce((s,o,a)=>{r.paths[a].at(0,i,!0);let l=i.velocity.reduce((u,h)=>u+h*h,0),c=i.spin.reduce((u,h)=>u+h*h,0);return s+(o.mass*l+o.inertia/e.R**2*c)/2},0);return 0}var XS=250,dc=class{constructor(e){this.stage=e;let{balls:t,rotates:i,scene:r}=e.data,[s,o]=[r.length_unit,r.time_unit],a=[`x, ${s}`,`y, ${s}`,`speed, ${s}/${o}`,...i?[`spin, rad/${o}`]:[],"state"],l=me("tr",{},me("th",{scope:"col"},"ball"),...a.map(h=>me("th",{scope:"col",class:"r"},h))),c=t.map(h=>{let f=a.map(()=>me("td",{class:"r"}));return this.cells.push(f),me("tr",{"data-ball":h.id},me("th",{scope:"row"},h.id),...f)}),u=me("table",{},this.caption,me("thead",{},l),me("tbody",{},...c));this.element=me("details",{class:"rp-readout"},me("summary",{},"Where the balls are now"),me("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":"Where the balls are now"},u))}stage;element;caption=me("caption",{});cells=[];last=-1/0;tell(e,t,i){let r=performance.now();if(i&&(!this.element.open||r-this.last<XS))return;this.last=r;let{data:s,end:o}=this.stage,a=e.scatters[t],l=th(s.R,4);zn(this.caption,`${a.run.facts.label} at ${Oi(e.time,o)} ${s.scene.time_unit}`),this.cells.forEach((c,u)=>{let h=g=>s.origin[g]+s.R*a.positions[3*u+g],f=g=>Math.hypot(g[3*u],g[3*u+1],g[3*u+2]),p=f(a.velocities)*s.R,m=f(a.spins),M=a.present[u]?p>0?"moves":m>0?"spins":"rests":"fallen";[h(0).toFixed(l),h(1).toFixed(l),fs(p,5),...s.rotates?[fs(m,5)]:[],M].forEach((g,v)=>zn(c[v],g))})}};var Wd=0,Nh=1,Xd=2;var oo=1,qd=2,vs=3,An=0,ei=1,yi=2,cr=0,Vr=1,Oh=2,Bh=3,kh=4,Yd=5;var Wr=100,Kd=101,$d=102,Zd=103,Jd=104,Qd=200,jd=201,em=202,tm=203,mc=204,gc=205,im=206,nm=207,rm=208,sm=209,om=210,am=211,lm=212,cm=213,um=214,ya=0,ba=1,Ea=2,Xr=3,wa=4,Ta=5,Aa=6,Ra=7,ao=0,hm=1,fm=2,pn=0,xc=1,_c=2,vc=3,Mc=4,Sc=5,yc=6,lo=7;var Gh=300,ur=301,qr=302,bc=303,Ec=304,Yr=1e3,en=1001,Ca=1002,Jt=1003,pm=1004;var Pa=1005;var xi=1006,wc=1007;var dn=1008;var ui=1009,Tc=1010,Ac=1011,br=1012,co=1013,Li=1014,bi=1015,Di=1016,uo=1017,ho=1018,Xn=1020,Rc=35902,Cc=35899,Pc=1021,Lc=1022,Hi=1023,tn=1026,mn=1027,fo=1028,po=1029,gn=1030,mo=1031;var go=1033,xo=33776,_o=33777,vo=33778,Mo=33779,La=35840,Da=35841,Ia=35842,Ua=35843,Fa=36196,Na=37492,Oa=37496,Ba=37488,ka=37489,Ms=37490,Ga=37491,za=37808,Ha=37809,Va=37810,Wa=37811,Xa=37812,qa=37813,Ya=37814,Ka=37815,$a=37816,Za=37817,Ja=37818,Qa=37819,ja=37820,el=37821,tl=36492,il=36494,nl=36495,rl=36283,sl=36284,Ss=36285,ol=36286;var dm=3200;var al=0,mm=1,Rn="",Ei="srgb",ys="srgb-linear",bs="linear",Pt="srgb";var Dc=7680;var gm=519,xm=512,_m=513,vm=514,Ic=515,Mm=516,Sm=517,Uc=518,Fc=519,ym=35044,bm=35048;var zh="300 es",ki=2e3,Er=2001;function wm(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function yo(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Tm(){let n=yo("canvas");return n.style.display="block",n}var Em={},So=null;function Hh(...n){let e="THREE."+n.shift();So?So("log",e,...n):console.log(e,...n)}function Am(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Xe(...n){n=Am(n);let e="THREE."+n.shift();if(So)So("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function bt(...n){n=Am(n);let e="THREE."+n.shift();if(So)So("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Es(...n){let e=n.join(" ");e in Em||(Em[e]=!0,Xe(...n))}function Rm(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Cm={[ya]:ya,[Ea]:Aa,[wa]:wa,[Xr]:Ta,[ba]:ba,[Aa]:Ea,[Ra]:Ra,[Ta]:Xr};var Vi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}};var Wi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Nc=Math.PI/180,ll=180/Math.PI;function Cn(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Wi[n&255]+Wi[n>>8&255]+Wi[n>>16&255]+Wi[n>>24&255]+"-"+Wi[e&255]+Wi[e>>8&255]+"-"+Wi[e>>16&15|64]+Wi[e>>24&255]+"-"+Wi[t&63|128]+Wi[t>>8&255]+"-"+Wi[t>>16&255]+Wi[t>>24&255]+Wi[i&255]+Wi[i>>8&255]+Wi[i>>16&255]+Wi[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function Pm(n,e){return(n%e+e)%e}function Oc(n,e,t){return(1-t)*n+t*e}function Lm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Bc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Dm(n,e){if(e.constructor===Float32Array)return n;let t=Bc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Im(n,e){if(e.constructor===Float32Array)return n;let t=Bc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var le=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};var Ii=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],u=i[r+2],h=i[r+3],f=s[o+0],p=s[o+1],m=s[o+2],M=s[o+3];if(h!==M||l!==f||c!==p||u!==m){let d=l*f+c*p+u*m+h*M;d<0&&(f=-f,p=-p,m=-m,M=-M,d=-d);let g=1-a;if(d<.9995){let v=Math.acos(d),T=Math.sin(v);g=Math.sin(g*v)/T,a=Math.sin(a*v)/T,l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,h=h*g+M*a}else{l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,h=h*g+M*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],u=i[r+3],h=s[o],f=s[o+1],p=s[o+2],m=s[o+3];return e[t]=a*m+u*h+l*p-c*f,e[t+1]=l*m+u*f+c*h-a*p,e[t+2]=c*m+u*p+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(r/2),h=a(s/2),f=l(i/2),p=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"YXZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"ZXY":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"ZYX":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"YZX":this._x=f*u*h+c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h-f*p*m;break;case"XZY":this._x=f*u*h-c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h+f*p*m;break;default:Xe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-i*c,this._z=s*u+o*c+i*l-r*a,this._w=o*u-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}};var O=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Um.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Um.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),u=2*(a*t-s*r),h=2*(s*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Vh.copy(this).projectOnVector(e),this.sub(Vh)}reflect(e){return this.sub(Vh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Vh=new O,Um=new Ii;var et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],m=i[8],M=r[0],d=r[3],g=r[6],v=r[1],T=r[4],S=r[7],C=r[2],A=r[5],x=r[8];return s[0]=o*M+a*v+l*C,s[3]=o*d+a*T+l*A,s[6]=o*g+a*S+l*x,s[1]=c*M+u*v+h*C,s[4]=c*d+u*T+h*A,s[7]=c*g+u*S+h*x,s[2]=f*M+p*v+m*C,s[5]=f*d+p*T+m*A,s[8]=f*g+p*S+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*s*u+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*s,p=c*s-o*l,m=t*h+i*f+r*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/m;return e[0]=h*M,e[1]=(r*c-u*i)*M,e[2]=(a*i-r*o)*M,e[3]=f*M,e[4]=(u*t-r*l)*M,e[5]=(r*s-a*t)*M,e[6]=p*M,e[7]=(i*l-c*t)*M,e[8]=(o*t-i*s)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Wh.makeScale(e,t)),this}rotate(e){return Es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Wh.makeRotation(-e)),this}translate(e,t){return Es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Wh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Wh=new et;var Fm=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Nm=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function qS(){let n={enabled:!0,workingColorSpace:ys,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Pt&&(r.r=qn(r.r),r.g=qn(r.g),r.b=qn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(r.r=ws(r.r),r.g=ws(r.g),r.b=ws(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Rn?bs:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ys]:{primaries:e,whitePoint:i,transfer:bs,toXYZ:Fm,fromXYZ:Nm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ei},outputColorSpaceConfig:{drawingBufferColorSpace:Ei}},[Ei]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:Fm,fromXYZ:Nm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ei}}}),n}var _t=qS();function qn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ws(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var bo,kc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{bo===void 0&&(bo=yo("canvas")),bo.width=e.width,bo.height=e.height;let r=bo.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=bo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=yo("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=qn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(qn(t[i]/255)*255):t[i]=qn(t[i]);return{data:t,width:e.width,height:e.height}}else return Xe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}};var YS=0,Kr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:YS++}),this.uuid=Cn(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Xh(r[o].image)):s.push(Xh(r[o]))}else s=Xh(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Xh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?kc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Xe("Texture: Unable to serialize Texture."),{})}var KS=0,qh=new O,ti=class n extends Vi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=en,r=en,s=xi,o=dn,a=Hi,l=ui,c=n.DEFAULT_ANISOTROPY,u=Rn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:KS++}),this.uuid=Cn(),this.name="",this.source=new Kr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new le(0,0),this.repeat=new le(1,1),this.center=new le(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(qh).x}get height(){return this.source.getSize(qh).y}get depth(){return this.source.getSize(qh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Xe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Xe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Gh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Yr:e.x=e.x-Math.floor(e.x);break;case en:e.x=e.x<0?0:1;break;case Ca:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Yr:e.y=e.y-Math.floor(e.y);break;case en:e.y=e.y<0?0:1;break;case Ca:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=Gh;ti.DEFAULT_ANISOTROPY=1;var It=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],m=l[9],M=l[2],d=l[6],g=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-M)<.01&&Math.abs(m-d)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+M)<.1&&Math.abs(m+d)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(p+1)/2,C=(g+1)/2,A=(u+f)/4,x=(h+M)/4,E=(m+d)/4;return T>S&&T>C?T<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(T),r=A/i,s=x/i):S>C?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=A/r,s=E/r):C<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(C),i=x/s,r=E/s),this.set(i,r,s,t),this}let v=Math.sqrt((d-m)*(d-m)+(h-M)*(h-M)+(f-u)*(f-u));return Math.abs(v)<.001&&(v=1),this.x=(d-m)/v,this.y=(h-M)/v,this.z=(f-u)/v,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var Gc=class extends Vi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ti({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Kr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Gi=class extends Gc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}};var Eo=class extends ti{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Jt,this.minFilter=Jt,this.wrapR=en,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var zc=class extends ti{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Jt,this.minFilter=Jt,this.wrapR=en,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var st=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d)}set(e,t,i,r,s,o,a,l,c,u,h,f,p,m,M,d){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=f,g[3]=p,g[7]=m,g[11]=M,g[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/wo.setFromMatrixColumn(e,0).length(),s=1/wo.setFromMatrixColumn(e,1).length(),o=1/wo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){let f=o*u,p=o*h,m=a*u,M=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+m*c,t[5]=f-M*c,t[9]=-a*l,t[2]=M-f*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,m=c*u,M=c*h;t[0]=f+M*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=M+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,m=c*u,M=c*h;t[0]=f-M*a,t[4]=-o*h,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=M-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,m=a*u,M=a*h;t[0]=l*u,t[4]=m*c-p,t[8]=f*c+M,t[1]=l*h,t[5]=M*c+f,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,m=a*l,M=a*c;t[0]=l*u,t[4]=M-f*h,t[8]=m*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+m,t[10]=f-M*h}else if(e.order==="XZY"){let f=o*l,p=o*c,m=a*l,M=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+M,t[5]=o*u,t[9]=p*h-m,t[2]=m*h-p,t[6]=a*u,t[10]=M*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose($S,e,ZS)}lookAt(e,t,i){let r=this.elements;return xn.subVectors(e,t),xn.lengthSq()===0&&(xn.z=1),xn.normalize(),$r.crossVectors(i,xn),$r.lengthSq()===0&&(Math.abs(i.z)===1?xn.x+=1e-4:xn.z+=1e-4,xn.normalize(),$r.crossVectors(i,xn)),$r.normalize(),Hc.crossVectors(xn,$r),r[0]=$r.x,r[4]=Hc.x,r[8]=xn.x,r[1]=$r.y,r[5]=Hc.y,r[9]=xn.y,r[2]=$r.z,r[6]=Hc.z,r[10]=xn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],m=i[2],M=i[6],d=i[10],g=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=r[0],x=r[4],E=r[8],B=r[12],D=r[1],L=r[5],G=r[9],W=r[13],I=r[2],H=r[6],q=r[10],z=r[14],ce=r[3],$=r[7],Q=r[11],ee=r[15];return s[0]=o*A+a*D+l*I+c*ce,s[4]=o*x+a*L+l*H+c*$,s[8]=o*E+a*G+l*q+c*Q,s[12]=o*B+a*W+l*z+c*ee,s[1]=u*A+h*D+f*I+p*ce,s[5]=u*x+h*L+f*H+p*$,s[9]=u*E+h*G+f*q+p*Q,s[13]=u*B+h*W+f*z+p*ee,s[2]=m*A+M*D+d*I+g*ce,s[6]=m*x+M*L+d*H+g*$,s[10]=m*E+M*G+d*q+g*Q,s[14]=m*B+M*W+d*z+g*ee,s[3]=v*A+T*D+S*I+C*ce,s[7]=v*x+T*L+S*H+C*$,s[11]=v*E+T*G+S*q+C*Q,s[15]=v*B+T*W+S*z+C*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],m=e[3],M=e[7],d=e[11],g=e[15],v=l*p-c*f,T=a*p-c*h,S=a*f-l*h,C=o*p-c*u,A=o*f-l*u,x=o*h-a*u;return t*(M*v-d*T+g*S)-i*(m*v-d*C+g*A)+r*(m*T-M*C+g*x)-s*(m*S-M*A+d*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],m=e[12],M=e[13],d=e[14],g=e[15],v=t*a-i*o,T=t*l-r*o,S=t*c-s*o,C=i*l-r*a,A=i*c-s*a,x=r*c-s*l,E=u*M-h*m,B=u*d-f*m,D=u*g-p*m,L=h*d-f*M,G=h*g-p*M,W=f*g-p*d,I=v*W-T*G+S*L+C*D-A*B+x*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/I;return e[0]=(a*W-l*G+c*L)*H,e[1]=(r*G-i*W-s*L)*H,e[2]=(M*x-d*A+g*C)*H,e[3]=(f*A-h*x-p*C)*H,e[4]=(l*D-o*W-c*B)*H,e[5]=(t*W-r*D+s*B)*H,e[6]=(d*S-m*x-g*T)*H,e[7]=(u*x-f*S+p*T)*H,e[8]=(o*G-a*D+c*E)*H,e[9]=(i*D-t*G-s*E)*H,e[10]=(m*A-M*S+g*v)*H,e[11]=(h*S-u*A-p*v)*H,e[12]=(a*B-o*L-l*E)*H,e[13]=(t*L-i*B+r*E)*H,e[14]=(M*T-m*C-d*v)*H,e[15]=(u*C-h*T+f*v)*H,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+i,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,h=a+a,f=s*c,p=s*u,m=s*h,M=o*u,d=o*h,g=a*h,v=l*c,T=l*u,S=l*h,C=i.x,A=i.y,x=i.z;return r[0]=(1-(M+g))*C,r[1]=(p+S)*C,r[2]=(m-T)*C,r[3]=0,r[4]=(p-S)*A,r[5]=(1-(f+g))*A,r[6]=(d+v)*A,r[7]=0,r[8]=(m+T)*x,r[9]=(d-v)*x,r[10]=(1-(f+M))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=wo.set(r[0],r[1],r[2]).length(),a=wo.set(r[4],r[5],r[6]).length(),l=wo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Yn.copy(this);let c=1/o,u=1/a,h=1/l;return Yn.elements[0]*=c,Yn.elements[1]*=c,Yn.elements[2]*=c,Yn.elements[4]*=u,Yn.elements[5]*=u,Yn.elements[6]*=u,Yn.elements[8]*=h,Yn.elements[9]*=h,Yn.elements[10]*=h,t.setFromRotationMatrix(Yn),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=ki,l=!1){let c=this.elements,u=2*s/(t-e),h=2*s/(i-r),f=(t+e)/(t-e),p=(i+r)/(i-r),m,M;if(l)m=s/(o-s),M=o*s/(o-s);else if(a===ki)m=-(o+s)/(o-s),M=-2*o*s/(o-s);else if(a===Er)m=-o/(o-s),M=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=ki,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-r),f=-(t+e)/(t-e),p=-(i+r)/(i-r),m,M;if(l)m=1/(o-s),M=o/(o-s);else if(a===ki)m=-2/(o-s),M=-(o+s)/(o-s);else if(a===Er)m=-1/(o-s),M=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},wo=new O,Yn=new st,$S=new O(0,0,0),ZS=new O(1,1,1),$r=new O,Hc=new O,xn=new O;var Om=new st,Bm=new Ii,Pn=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(xt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Xe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Om.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Om,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Bm.setFromEuler(this),this.setFromQuaternion(Bm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var To=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}};var JS=0,km=new O,Ao=new Ii,wr=new st,Vc=new O,cl=new O,QS=new O,jS=new Ii,Gm=new O(1,0,0),zm=new O(0,1,0),Hm=new O(0,0,1),Vm={type:"added"},ey={type:"removed"},Ro={type:"childadded",child:null},Yh={type:"childremoved",child:null},Qt=class n extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:JS++}),this.uuid=Cn(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new O,t=new Pn,i=new Ii,r=new O(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new st},normalMatrix:{value:new et}}),this.matrix=new st,this.matrixWorld=new st,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new To,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ao.setFromAxisAngle(e,t),this.quaternion.multiply(Ao),this}rotateOnWorldAxis(e,t){return Ao.setFromAxisAngle(e,t),this.quaternion.premultiply(Ao),this}rotateX(e){return this.rotateOnAxis(Gm,e)}rotateY(e){return this.rotateOnAxis(zm,e)}rotateZ(e){return this.rotateOnAxis(Hm,e)}translateOnAxis(e,t){return km.copy(e).applyQuaternion(this.quaternion),this.position.add(km.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Gm,e)}translateY(e){return this.translateOnAxis(zm,e)}translateZ(e){return this.translateOnAxis(Hm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(wr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Vc.copy(e):Vc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),cl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?wr.lookAt(cl,Vc,this.up):wr.lookAt(Vc,cl,this.up),this.quaternion.setFromRotationMatrix(wr),r&&(wr.extractRotation(r.matrixWorld),Ao.setFromRotationMatrix(wr),this.quaternion.premultiply(Ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(bt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Vm),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null):bt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ey),Yh.child=e,this.dispatchEvent(Yh),Yh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),wr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),wr.multiply(e.parent.matrixWorld)),e.applyMatrix4(wr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Vm),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cl,e,QS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cl,jS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(e.shapes,h)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new O(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var nn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}};var ty={type:"move"},Co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new nn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new nn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new nn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let d=t.getJointPose(M,i),g=this._getHandJoint(c,M);d!==null&&(g.matrix.fromArray(d.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=d.radius),g.visible=d!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ty)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new nn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var Wm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zr={h:0,s:0,l:0},Wc={h:0,s:0,l:0};function Kh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var tt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ei){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=_t.workingColorSpace){if(e=Pm(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Kh(o,s,e+1/3),this.g=Kh(o,s,e),this.b=Kh(o,s,e-1/3)}return _t.colorSpaceToWorking(this,r),this}setStyle(e,t=Ei){function i(s){s!==void 0&&parseFloat(s)<1&&Xe("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Xe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Xe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ei){let i=Wm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Xe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=qn(e.r),this.g=qn(e.g),this.b=qn(e.b),this}copyLinearToSRGB(e){return this.r=ws(e.r),this.g=ws(e.g),this.b=ws(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ei){return _t.workingToColorSpace(Xi.copy(this),e),Math.round(xt(Xi.r*255,0,255))*65536+Math.round(xt(Xi.g*255,0,255))*256+Math.round(xt(Xi.b*255,0,255))}getHexString(e=Ei){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Xi.copy(this),t);let i=Xi.r,r=Xi.g,s=Xi.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-i)/h+2;break;case s:l=(i-r)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Xi.copy(this),t),e.r=Xi.r,e.g=Xi.g,e.b=Xi.b,e}getStyle(e=Ei){_t.workingToColorSpace(Xi.copy(this),e);let t=Xi.r,i=Xi.g,r=Xi.b;return e!==Ei?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Zr),this.setHSL(Zr.h+e,Zr.s+t,Zr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Zr),e.getHSL(Wc);let i=Oc(Zr.h,Wc.h,t),r=Oc(Zr.s,Wc.s,t),s=Oc(Zr.l,Wc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xi=new tt;tt.NAMES=Wm;var ul=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Kn=new O,Tr=new O,$h=new O,Ar=new O,Po=new O,Lo=new O,Xm=new O,Zh=new O,Jh=new O,Qh=new O,jh=new It,ef=new It,tf=new It,Jr=class n{constructor(e=new O,t=new O,i=new O){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Kn.subVectors(e,t),r.cross(Kn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Kn.subVectors(r,t),Tr.subVectors(i,t),$h.subVectors(e,t);let o=Kn.dot(Kn),a=Kn.dot(Tr),l=Kn.dot($h),c=Tr.dot(Tr),u=Tr.dot($h),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-p-m,m,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Ar)===null?!1:Ar.x>=0&&Ar.y>=0&&Ar.x+Ar.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Ar)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ar.x),l.addScaledVector(o,Ar.y),l.addScaledVector(a,Ar.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return jh.setScalar(0),ef.setScalar(0),tf.setScalar(0),jh.fromBufferAttribute(e,t),ef.fromBufferAttribute(e,i),tf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(jh,s.x),o.addScaledVector(ef,s.y),o.addScaledVector(tf,s.z),o}static isFrontFacing(e,t,i,r){return Kn.subVectors(i,t),Tr.subVectors(e,t),Kn.cross(Tr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Kn.subVectors(this.c,this.b),Tr.subVectors(this.a,this.b),Kn.cross(Tr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;Po.subVectors(r,i),Lo.subVectors(s,i),Zh.subVectors(e,i);let l=Po.dot(Zh),c=Lo.dot(Zh);if(l<=0&&c<=0)return t.copy(i);Jh.subVectors(e,r);let u=Po.dot(Jh),h=Lo.dot(Jh);if(u>=0&&h<=u)return t.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Po,o);Qh.subVectors(e,s);let p=Po.dot(Qh),m=Lo.dot(Qh);if(m>=0&&p<=m)return t.copy(s);let M=p*c-l*m;if(M<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Lo,a);let d=u*m-p*h;if(d<=0&&h-u>=0&&p-m>=0)return Xm.subVectors(s,r),a=(h-u)/(h-u+(p-m)),t.copy(r).addScaledVector(Xm,a);let g=1/(d+M+f);return o=M*g,a=f*g,t.copy(i).addScaledVector(Po,o).addScaledVector(Lo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}};var Ln=class{constructor(e=new O(1/0,1/0,1/0),t=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint($n.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint($n.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=$n.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$n):$n.fromBufferAttribute(s,o),$n.applyMatrix4(e.matrixWorld),this.expandByPoint($n);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Xc.copy(i.boundingBox)),Xc.applyMatrix4(e.matrixWorld),this.union(Xc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$n),$n.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(hl),qc.subVectors(this.max,hl),Do.subVectors(e.a,hl),Io.subVectors(e.b,hl),Uo.subVectors(e.c,hl),Qr.subVectors(Io,Do),jr.subVectors(Uo,Io),Ts.subVectors(Do,Uo);let t=[0,-Qr.z,Qr.y,0,-jr.z,jr.y,0,-Ts.z,Ts.y,Qr.z,0,-Qr.x,jr.z,0,-jr.x,Ts.z,0,-Ts.x,-Qr.y,Qr.x,0,-jr.y,jr.x,0,-Ts.y,Ts.x,0];return!nf(t,Do,Io,Uo,qc)||(t=[1,0,0,0,1,0,0,0,1],!nf(t,Do,Io,Uo,qc))?!1:(Yc.crossVectors(Qr,jr),t=[Yc.x,Yc.y,Yc.z],nf(t,Do,Io,Uo,qc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$n).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($n).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Rr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Rr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Rr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Rr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Rr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Rr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Rr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Rr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Rr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Rr=[new O,new O,new O,new O,new O,new O,new O,new O],$n=new O,Xc=new Ln,Do=new O,Io=new O,Uo=new O,Qr=new O,jr=new O,Ts=new O,hl=new O,qc=new O,Yc=new O,As=new O;function nf(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){As.fromArray(n,s);let a=r.x*Math.abs(As.x)+r.y*Math.abs(As.y)+r.z*Math.abs(As.z),l=e.dot(As),c=t.dot(As),u=i.dot(As);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var _i=new O,Kc=new le,iy=0,_n=class extends Vi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:iy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=ym,this.updateRanges=[],this.gpuType=bi,this.version=0,this._normalizationScale=e!==void 0?Bc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Kc.fromBufferAttribute(this,t),Kc.applyMatrix3(e),this.setXY(t,Kc.x,Kc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix3(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyMatrix4(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.applyNormalMatrix(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)_i.fromBufferAttribute(this,t),_i.transformDirection(e),this.setXYZ(t,_i.x,_i.y,_i.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Dm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Im(e,this.array)}};var Fo=class extends _n{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var No=class extends _n{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mt=class extends _n{constructor(e,t,i){super(new Float32Array(e),t,i)}};var ny=new Ln,fl=new O,rf=new O,Zn=class{constructor(e=new O,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):ny.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;fl.subVectors(e,this.center);let t=fl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(fl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(rf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(fl.copy(e.center).add(rf)),this.expandByPoint(fl.copy(e.center).sub(rf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}};var ry=0,Dn=new st,sf=new Qt,Oo=new O,vn=new Ln,pl=new Ln,Ui=new O,zt=class n extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ry++}),this.uuid=Cn(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(wm(e)?No:Fo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new et().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Dn.makeRotationFromQuaternion(e),this.applyMatrix4(Dn),this}rotateX(e){return Dn.makeRotationX(e),this.applyMatrix4(Dn),this}rotateY(e){return Dn.makeRotationY(e),this.applyMatrix4(Dn),this}rotateZ(e){return Dn.makeRotationZ(e),this.applyMatrix4(Dn),this}translate(e,t,i){return Dn.makeTranslation(e,t,i),this.applyMatrix4(Dn),this}scale(e,t,i){return Dn.makeScale(e,t,i),this.applyMatrix4(Dn),this}lookAt(e){return sf.lookAt(e),sf.updateMatrix(),this.applyMatrix4(sf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Oo).negate(),this.translate(Oo.x,Oo.y,Oo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Xe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ln);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){bt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];vn.setFromBufferAttribute(s),this.morphTargetsRelative?(Ui.addVectors(this.boundingBox.min,vn.min),this.boundingBox.expandByPoint(Ui),Ui.addVectors(this.boundingBox.max,vn.max),this.boundingBox.expandByPoint(Ui)):(this.boundingBox.expandByPoint(vn.min),this.boundingBox.expandByPoint(vn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&bt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){bt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(e){let i=this.boundingSphere.center;if(vn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];pl.setFromBufferAttribute(a),this.morphTargetsRelative?(Ui.addVectors(vn.min,pl.min),vn.expandByPoint(Ui),Ui.addVectors(vn.max,pl.max),vn.expandByPoint(Ui)):(vn.expandByPoint(pl.min),vn.expandByPoint(pl.max))}vn.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Ui.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Ui));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Ui.fromBufferAttribute(a,c),l&&(Oo.fromBufferAttribute(e,c),Ui.add(Oo)),r=Math.max(r,i.distanceToSquared(Ui))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&bt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){bt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new _n(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new O,l[B]=new O;let u=new O,h=new O,f=new O,p=new le,m=new le,M=new le,d=new O,g=new O;function v(B,D,L){c[B]=c[D]=c[L]=1,u.fromBufferAttribute(i,B),h.fromBufferAttribute(i,D),f.fromBufferAttribute(i,L),p.fromBufferAttribute(s,B),m.fromBufferAttribute(s,D),M.fromBufferAttribute(s,L),h.sub(u),f.sub(u),m.sub(p),M.sub(p);let G=1/(m.x*M.y-M.x*m.y);isFinite(G)&&(d.copy(h).multiplyScalar(M.y).addScaledVector(f,-m.y).multiplyScalar(G),g.copy(f).multiplyScalar(m.x).addScaledVector(h,-M.x).multiplyScalar(G),a[B].add(d),a[D].add(d),a[L].add(d),l[B].add(g),l[D].add(g),l[L].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let B=0,D=T.length;B<D;++B){let L=T[B],G=L.start,W=L.count;for(let I=G,H=G+W;I<H;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new O,C=new O,A=new O,x=new O;function E(B){A.fromBufferAttribute(r,B),x.copy(A);let D=a[B];S.copy(D),S.sub(A.multiplyScalar(A.dot(D))).normalize(),C.crossVectors(x,D);let G=C.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,G)}for(let B=0,D=i.count;B<D;++B)c[B]&&E(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new _n(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let r=new O,s=new O,o=new O,a=new O,l=new O,c=new O,u=new O,h=new O;if(e)for(let f=0,p=e.count;f<p;f+=3){let m=e.getX(f+0),M=e.getX(f+1),d=e.getX(f+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,M),o.fromBufferAttribute(t,d),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,M),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(M,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Ui.fromBufferAttribute(e,t),Ui.normalize(),e.setXYZ(t,Ui.x,Ui.y,Ui.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,m=0;for(let M=0,d=l.length;M<d;M++){a.isInterleavedBufferAttribute?p=l[M]*a.data.stride+a.offset:p=l[M]*u;for(let g=0;g<u;g++)f[m++]=c[p++]}return new _n(f,u,h)}if(this.index===null)return Xe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var of=new O,sy=new O,oy=new et,Mn=class{constructor(e=new O(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=of.subVectors(i,t).cross(sy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(of),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||oy.getNormalMatrix(e),r=this.coplanarPoint(of).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}};var ay=0,In=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ay++}),this.uuid=Cn(),this.name="",this.type="Material",this.blending=Vr,this.side=An,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=mc,this.blendDst=gc,this.blendEquation=Wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new tt(0,0,0),this.blendAlpha=0,this.depthFunc=Xr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=gm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dc,this.stencilZFail=Dc,this.stencilZPass=Dc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Xe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Xe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new tt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Mn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new le().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new le().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cr=new O,af=new O,$c=new O,Zc=new O,Jc=class{constructor(e=new O,t=new O(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cr.copy(this.origin).addScaledVector(this.direction,t),Cr.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){af.copy(e).add(t).multiplyScalar(.5),$c.copy(t).sub(e).normalize(),Zc.copy(this.origin).sub(af);let s=e.distanceTo(t)*.5,o=-this.direction.dot($c),a=Zc.dot(this.direction),l=-Zc.dot($c),c=Zc.lengthSq(),u=Math.abs(1-o*o),h,f,p,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let M=1/u;h*=M,f*=M,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),p=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),p=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),p=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(af).addScaledVector($c,f),p}intersectSphere(e,t){if(e.radius<0)return null;Cr.subVectors(e.center,this.origin);let i=Cr.dot(this.direction),r=Cr.dot(Cr)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),u>=0?(s=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(s=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Cr)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,p=e.z-o.z,m=t.x-o.x,M=t.y-o.y,d=t.z-o.z,g=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(u),x,E,B,D,L,G,W,I,H,q,z,ce;if(S>=C&&S>=A?(B=l,G=h,H=m,ce=g,l>=0?(x=c,E=u,D=f,L=p,W=M,I=d,q=v,z=T):(x=u,E=c,D=p,L=f,W=d,I=M,q=T,z=v)):C>=A?(B=c,G=f,H=M,ce=v,c>=0?(x=u,E=l,D=p,L=h,W=d,I=m,q=T,z=g):(x=l,E=u,D=h,L=p,W=m,I=d,q=g,z=T)):(B=u,G=p,H=d,ce=T,u>=0?(x=l,E=c,D=h,L=f,W=m,I=M,q=g,z=v):(x=c,E=l,D=f,L=h,W=M,I=m,q=v,z=g)),B===0)return null;let $=x/B,Q=E/B,ee=1/B,pe=D-$*G,ue=L-Q*G,j=W-$*H,xe=I-Q*H,ve=q-$*ce,De=z-Q*ce,Ee=ve*xe-De*j,He=pe*De-ue*ve,ot=j*ue-xe*pe;if(r){if(Ee<0||He<0||ot<0)return null}else if((Ee<0||He<0||ot<0)&&(Ee>0||He>0||ot>0))return null;let Je=Ee+He+ot;if(Je===0)return null;let at=ee*(Ee*G+He*H+ot*ce);return(Je>0?at<0:at>0)?null:this.at(at/Je,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}};var Un=class extends In{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=ao,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var qm=new st,Rs=new Jc,Qc=new Zn,Ym=new O,jc=new O,eu=new O,tu=new O,lf=new O,iu=new O,Km=new O,nu=new O,At=class extends Qt{constructor(e=new zt,t=new Un){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){iu.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(lf.fromBufferAttribute(h,e),o?iu.addScaledVector(lf,u):iu.addScaledVector(lf.sub(t),u))}t.add(iu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Qc.copy(i.boundingSphere),Qc.applyMatrix4(s),Rs.copy(e.ray).recast(e.near),!(Qc.containsPoint(Rs.origin)===!1&&(Rs.intersectSphere(Qc,Ym)===null||Rs.origin.distanceToSquared(Ym)>(e.far-e.near)**2))&&(qm.copy(s).invert(),Rs.copy(e.ray).applyMatrix4(qm),!(i.boundingBox!==null&&Rs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Rs)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,M=f.length;m<M;m++){let d=f[m],g=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);r=ru(this,g,e,i,c,u,h,A,x,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),M=Math.min(a.count,p.start+p.count);for(let d=m,g=M;d<g;d+=3){let v=a.getX(d),T=a.getX(d+1),S=a.getX(d+2);r=ru(this,o,e,i,c,u,h,v,T,S),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,M=f.length;m<M;m++){let d=f[m],g=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=S,x=S+1,E=S+2;r=ru(this,g,e,i,c,u,h,A,x,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=d.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),M=Math.min(l.count,p.start+p.count);for(let d=m,g=M;d<g;d+=3){let v=d,T=d+1,S=d+2;r=ru(this,o,e,i,c,u,h,v,T,S),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}};function ly(n,e,t,i,r,s,o,a){let l;if(e.side===ei?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===An,a),l===null)return null;nu.copy(a),nu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(nu);return c<t.near||c>t.far?null:{distance:c,point:nu.clone(),object:n}}function ru(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,jc),n.getVertexPosition(l,eu),n.getVertexPosition(c,tu);let u=ly(n,e,t,i,jc,eu,tu,Km);if(u){let h=new O;Jr.getBarycoord(Km,jc,eu,tu,h),r&&(u.uv=Jr.getInterpolatedAttribute(r,a,l,c,h,new le)),s&&(u.uv1=Jr.getInterpolatedAttribute(s,a,l,c,h,new le)),o&&(u.normal=Jr.getInterpolatedAttribute(o,a,l,c,h,new O),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new O,materialIndex:0};Jr.getNormal(jc,eu,tu,f.normal),u.face=f,u.barycoord=h}return u}var Bo=class extends ti{constructor(e=null,t=1,i=1,r,s,o,a,l,c=Jt,u=Jt,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var hr=class extends _n{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var ko=new st,$m=new st,su=[],Zm=new Ln,cy=new st,dl=new At,ml=new Zn,Jn=class extends At{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new hr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,cy)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ln),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ko),Zm.copy(e.boundingBox).applyMatrix4(ko),this.boundingBox.union(Zm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Zn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ko),ml.copy(e.boundingSphere).applyMatrix4(ko),this.boundingSphere.union(ml)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let a=0;a<i.length;a++)i[a]=r[o+a]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(dl.geometry=this.geometry,dl.material=this.material,dl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ml.copy(this.boundingSphere),ml.applyMatrix4(i),e.ray.intersectsSphere(ml)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,ko),$m.multiplyMatrices(i,ko),dl.matrixWorld=$m,dl.raycast(e,su);for(let o=0,a=su.length;o<a;o++){let l=su[o];l.instanceId=s,l.object=this,t.push(l)}su.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new hr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new Bo(new Float32Array(r*this.count),r,this.count,fo,bi));let s=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=r*e;return s[l]=a,s.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}};var Cs=new Zn,uy=new le(.5,.5),ou=new O,Qn=class{constructor(e=new Mn,t=new Mn,i=new Mn,r=new Mn,s=new Mn,o=new Mn){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ki,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],p=s[7],m=s[8],M=s[9],d=s[10],g=s[11],v=s[12],T=s[13],S=s[14],C=s[15];if(r[0].setComponents(c-o,p-u,g-m,C-v).normalize(),r[1].setComponents(c+o,p+u,g+m,C+v).normalize(),r[2].setComponents(c+a,p+h,g+M,C+T).normalize(),r[3].setComponents(c-a,p-h,g-M,C-T).normalize(),i)r[4].setComponents(l,f,d,S).normalize(),r[5].setComponents(c-l,p-f,g-d,C-S).normalize();else if(r[4].setComponents(c-l,p-f,g-d,C-S).normalize(),t===ki)r[5].setComponents(c+l,p+f,g+d,C+S).normalize();else if(t===Er)r[5].setComponents(l,f,d,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Cs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Cs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Cs)}intersectsSprite(e){Cs.center.set(0,0,0);let t=uy.distanceTo(e.center);return Cs.radius=.7071067811865476+t,Cs.applyMatrix4(e.matrixWorld),this.intersectsSphere(Cs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(ou.x=r.normal.x>0?e.max.x:e.min.x,ou.y=r.normal.y>0?e.max.y:e.min.y,ou.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(ou)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Jm=new st,au=class n{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Jm.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new Qn),i[r].setFromProjectionMatrix(Jm,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Qn),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Go=class extends ti{constructor(e=[],t=ur,i,r,s,o,a,l,c,u){super(e,t,i,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var es=class extends ti{constructor(e,t,i,r,s,o,a,l,c){super(e,t,i,r,s,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Sn=class extends ti{constructor(e,t,i=Li,r,s,o,a=Jt,l=Jt,c,u=tn,h=1){if(u!==tn&&u!==mn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,r,s,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Kr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}};var zo=class extends Sn{constructor(e,t=Li,i=ur,r,s,o=Jt,a=Jt,l,c=tn){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}};var Ho=class extends ti{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var ts=class n extends zt{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function m(M,d,g,v,T,S,C,A,x,E,B){let D=S/x,L=C/E,G=S/2,W=C/2,I=A/2,H=x+1,q=E+1,z=0,ce=0,$=new O;for(let Q=0;Q<q;Q++){let ee=Q*L-W;for(let pe=0;pe<H;pe++){let ue=pe*D-G;$[M]=ue*v,$[d]=ee*T,$[g]=I,c.push($.x,$.y,$.z),$[M]=0,$[d]=0,$[g]=A>0?1:-1,u.push($.x,$.y,$.z),h.push(pe/x),h.push(1-Q/E),z+=1}}for(let Q=0;Q<E;Q++)for(let ee=0;ee<x;ee++){let pe=f+ee+H*Q,ue=f+ee+H*(Q+1),j=f+(ee+1)+H*(Q+1),xe=f+(ee+1)+H*Q;l.push(pe,ue,xe),l.push(ue,j,xe),ce+=6}a.addGroup(p,ce,B),p+=ce,f+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var gl=class n extends zt{constructor(e=1,t=32,i=0,r=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:i,thetaLength:r},t=Math.max(3,t);let s=[],o=[],a=[],l=[],c=new O,u=new le;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let p=i+h/t*r;c.x=e*Math.cos(p),c.y=e*Math.sin(p),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)s.push(h,h+1,0);this.setIndex(s),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.segments,e.thetaStart,e.thetaLength)}};var xl=class n extends zt{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],f=[],p=[],m=0,M=[],d=i/2,g=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(p,2));function v(){let S=new O,C=new O,A=0,x=(t-e)/i;for(let E=0;E<=s;E++){let B=[],D=E/s,L=D*(t-e)+e;for(let G=0;G<=r;G++){let W=G/r,I=W*l+a,H=Math.sin(I),q=Math.cos(I);C.x=L*H,C.y=-D*i+d,C.z=L*q,h.push(C.x,C.y,C.z),S.set(H,x,q).normalize(),f.push(S.x,S.y,S.z),p.push(W,1-D),B.push(m++)}M.push(B)}for(let E=0;E<r;E++)for(let B=0;B<s;B++){let D=M[B][E],L=M[B+1][E],G=M[B+1][E+1],W=M[B][E+1];(e>0||B!==0)&&(u.push(D,L,W),A+=3),(t>0||B!==s-1)&&(u.push(L,G,W),A+=3)}c.addGroup(g,A,0),g+=A}function T(S){let C=m,A=new le,x=new O,E=0,B=S===!0?e:t,D=S===!0?1:-1;for(let G=1;G<=r;G++)h.push(0,d*D,0),f.push(0,D,0),p.push(.5,.5),m++;let L=m;for(let G=0;G<=r;G++){let I=G/r*l+a,H=Math.cos(I),q=Math.sin(I);x.x=B*q,x.y=d*D,x.z=B*H,h.push(x.x,x.y,x.z),f.push(0,D,0),A.x=H*.5+.5,A.y=q*.5*D+.5,p.push(A.x,A.y),m++}for(let G=0;G<r;G++){let W=C+G,I=L+G;S===!0?u.push(I,I+1,W):u.push(I+1,I,W),E+=3}c.addGroup(g,E,S===!0?1:2),g+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Yo={};yv(Yo,{ArcCurve:()=>lu,CatmullRomCurve3:()=>cu,CubicBezierCurve:()=>Vo,CubicBezierCurve3:()=>uu,EllipseCurve:()=>is,LineCurve:()=>Wo,LineCurve3:()=>hu,QuadraticBezierCurve:()=>Xo,QuadraticBezierCurve3:()=>fu,SplineCurve:()=>qo});var ai=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Xe("Curve: .getPoint() not implemented.")}getPointAt(e,t){let i=this.getUtoTmapping(e);return this.getPoint(i,t)}getPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return t}getSpacedPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPointAt(i/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],i,r=this.getPoint(0),s=0;t.push(0);for(let o=1;o<=e;o++)i=this.getPoint(o/e),s+=i.distanceTo(r),t.push(s),r=i;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let i=this.getLengths(),r=0,s=i.length,o;t?o=t:o=e*i[s-1];let a=0,l=s-1,c;for(;a<=l;)if(r=Math.floor(a+(l-a)/2),c=i[r]-o,c<0)a=r+1;else if(c>0)l=r-1;else{l=r;break}if(r=l,i[r]===o)return r/(s-1);let u=i[r],f=i[r+1]-u,p=(o-u)/f;return(r+p)/(s-1)}getTangent(e,t){let r=e-1e-4,s=e+1e-4;r<0&&(r=0),s>1&&(s=1);let o=this.getPoint(r),a=this.getPoint(s),l=t||(o.isVector2?new le:new O);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let i=this.getUtoTmapping(e);return this.getTangent(i,t)}computeFrenetFrames(e,t=!1){let i=new O,r=[],s=[],o=[],a=new O,l=new st;for(let p=0;p<=e;p++){let m=p/e;r[p]=this.getTangentAt(m,new O)}s[0]=new O,o[0]=new O;let c=Number.MAX_VALUE,u=Math.abs(r[0].x),h=Math.abs(r[0].y),f=Math.abs(r[0].z);u<=c&&(c=u,i.set(1,0,0)),h<=c&&(c=h,i.set(0,1,0)),f<=c&&i.set(0,0,1),a.crossVectors(r[0],i).normalize(),s[0].crossVectors(r[0],a),o[0].crossVectors(r[0],s[0]);for(let p=1;p<=e;p++){if(s[p]=s[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(r[p-1],r[p]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(xt(r[p-1].dot(r[p]),-1,1));s[p].applyMatrix4(l.makeRotationAxis(a,m))}o[p].crossVectors(r[p],s[p])}if(t===!0){let p=Math.acos(xt(s[0].dot(s[e]),-1,1));p/=e,r[0].dot(a.crossVectors(s[0],s[e]))>0&&(p=-p);for(let m=1;m<=e;m++)s[m].applyMatrix4(l.makeRotationAxis(r[m],p*m)),o[m].crossVectors(r[m],s[m])}return{tangents:r,normals:s,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}};var is=class extends ai{constructor(e=0,t=0,i=1,r=1,s=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=i,this.yRadius=r,this.aStartAngle=s,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new le){let i=t,r=Math.PI*2,s=this.aEndAngle-this.aStartAngle,o=Math.abs(s)<Number.EPSILON;for(;s<0;)s+=r;for(;s>r;)s-=r;s<Number.EPSILON&&(o?s=0:s=r),this.aClockwise===!0&&!o&&(s===r?s=-r:s=s-r);let a=this.aStartAngle+e*s,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return i.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}};var lu=class extends is{constructor(e,t,i,r,s,o){super(e,t,i,i,r,s,o),this.isArcCurve=!0,this.type="ArcCurve"}};function ff(){let n=0,e=0,t=0,i=0;function r(s,o,a,l){n=s,e=a,t=-3*s+3*o-2*a-l,i=2*s-2*o+a+l}return{initCatmullRom:function(s,o,a,l,c){r(o,a,c*(a-s),c*(l-o))},initNonuniformCatmullRom:function(s,o,a,l,c,u,h){let f=(o-s)/c-(a-s)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,r(o,a,f,p)},calc:function(s){let o=s*s,a=o*s;return n+e*s+t*o+i*a}}}var Qm=new O,jm=new O,cf=new ff,uf=new ff,hf=new ff,cu=class extends ai{constructor(e=[],t=!1,i="centripetal",r=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=i,this.tension=r}getPoint(e,t=new O){let i=t,r=this.points,s=r.length,o=(s-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/s)+1)*s:l===0&&a===s-1&&(a=s-2,l=1);let c,u;this.closed||a>0?c=r[(a-1)%s]:(jm.subVectors(r[0],r[1]).add(r[0]),c=jm);let h=r[a%s],f=r[(a+1)%s];if(this.closed||a+2<s?u=r[(a+2)%s]:(Qm.subVectors(r[s-1],r[s-2]).add(r[s-1]),u=Qm),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),p),M=Math.pow(h.distanceToSquared(f),p),d=Math.pow(f.distanceToSquared(u),p);M<1e-4&&(M=1),m<1e-4&&(m=M),d<1e-4&&(d=M),cf.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,m,M,d),uf.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,m,M,d),hf.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,m,M,d)}else this.curveType==="catmullrom"&&(cf.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),uf.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),hf.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return i.set(cf.calc(l),uf.calc(l),hf.calc(l)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(r.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let r=this.points[t];e.points.push(r.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(new O().fromArray(r))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function pf(n,e,t,i,r){let s=(i-e)*.5,o=(r-t)*.5,a=n*n,l=n*a;return(2*t-2*i+s+o)*l+(-3*t+3*i-2*s-o)*a+s*n+t}function hy(n,e){let t=1-n;return t*t*e}function fy(n,e){return 2*(1-n)*n*e}function py(n,e){return n*n*e}function Ps(n,e,t,i){return hy(n,e)+fy(n,t)+py(n,i)}function dy(n,e){let t=1-n;return t*t*t*e}function my(n,e){let t=1-n;return 3*t*t*n*e}function gy(n,e){return 3*(1-n)*n*n*e}function xy(n,e){return n*n*n*e}function Ls(n,e,t,i,r){return dy(n,e)+my(n,t)+gy(n,i)+xy(n,r)}var Vo=class extends ai{constructor(e=new le,t=new le,i=new le,r=new le){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=i,this.v3=r}getPoint(e,t=new le){let i=t,r=this.v0,s=this.v1,o=this.v2,a=this.v3;return i.set(Ls(e,r.x,s.x,o.x,a.x),Ls(e,r.y,s.y,o.y,a.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}};var uu=class extends ai{constructor(e=new O,t=new O,i=new O,r=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=i,this.v3=r}getPoint(e,t=new O){let i=t,r=this.v0,s=this.v1,o=this.v2,a=this.v3;return i.set(Ls(e,r.x,s.x,o.x,a.x),Ls(e,r.y,s.y,o.y,a.y),Ls(e,r.z,s.z,o.z,a.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}};var Wo=class extends ai{constructor(e=new le,t=new le){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new le){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new le){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var hu=class extends ai{constructor(e=new O,t=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new O){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new O){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var Xo=class extends ai{constructor(e=new le,t=new le,i=new le){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new le){let i=t,r=this.v0,s=this.v1,o=this.v2;return i.set(Ps(e,r.x,s.x,o.x),Ps(e,r.y,s.y,o.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var fu=class extends ai{constructor(e=new O,t=new O,i=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new O){let i=t,r=this.v0,s=this.v1,o=this.v2;return i.set(Ps(e,r.x,s.x,o.x),Ps(e,r.y,s.y,o.y),Ps(e,r.z,s.z,o.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}};var qo=class extends ai{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new le){let i=t,r=this.points,s=(r.length-1)*e,o=Math.floor(s),a=s-o,l=r[o===0?o:o-1],c=r[o],u=r[o>r.length-2?r.length-1:o+1],h=r[o>r.length-3?r.length-1:o+2];return i.set(pf(a,l.x,c.x,u.x,h.x),pf(a,l.y,c.y,u.y,h.y)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(r.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let r=this.points[t];e.points.push(r.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let r=e.points[t];this.points.push(new le().fromArray(r))}return this}};var pu=class extends ai{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let i=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Yo[i](t,e))}return this}getPoint(e,t){let i=e*this.getLength(),r=this.getCurveLengths(),s=0;for(;s<r.length;){if(r[s]>=i){let o=r[s]-i,a=this.curves[s],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}s++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let i=0,r=this.curves.length;i<r;i++)t+=this.curves[i].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],i;for(let r=0,s=this.curves;r<s.length;r++){let o=s[r],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let u=l[c];i&&i.equals(u)||(t.push(u),i=u)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let r=e.curves[t];this.curves.push(r.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,i=this.curves.length;t<i;t++){let r=this.curves[t];e.curves.push(r.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let r=e.curves[t];this.curves.push(new Yo[r.type]().fromJSON(r))}return this.cacheLengths=null,this}};var Pr=class extends pu{constructor(e){super(),this.type="Path",this.currentPoint=new le,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,i=e.length;t<i;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let i=new Wo(this.currentPoint.clone(),new le(e,t));return this.curves.push(i),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,i,r){let s=new Xo(this.currentPoint.clone(),new le(e,t),new le(i,r));return this.curves.push(s),this.currentPoint.set(i,r),this}bezierCurveTo(e,t,i,r,s,o){let a=new Vo(this.currentPoint.clone(),new le(e,t),new le(i,r),new le(s,o));return this.curves.push(a),this.currentPoint.set(s,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),i=new qo(t);return this.curves.push(i),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,i,r,s,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,i,r,s,o),this}absarc(e,t,i,r,s,o){return this.absellipse(e,t,i,i,r,s,o),this}ellipse(e,t,i,r,s,o,a,l){let c=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(e+c,t+u,i,r,s,o,a,l),this}absellipse(e,t,i,r,s,o,a,l){let c=new is(e,t,i,r,s,o,a,l);if(this.curves.length>0){let h=c.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(c);let u=c.getPoint(1);return this.currentPoint.copy(u),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}};var fr=class extends Pr{constructor(e){super(e),this.uuid=Cn(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let i=0,r=this.holes.length;i<r;i++)t[i]=this.holes[i].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let r=e.holes[t];this.holes.push(r.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,i=this.holes.length;t<i;t++){let r=this.holes[t];e.holes.push(r.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let r=e.holes[t];this.holes.push(new Pr().fromJSON(r))}return this}};function gf(n,e,t=2){let i=e&&e.length,r=i?e[0]*t:n.length,s=tg(n,0,r,t,!0),o=[];if(!s||s.next===s.prev)return o;let a,l,c;if(i&&(s=yy(n,e,s,t)),n.length>80*t){a=n[0],l=n[1];let u=a,h=l;for(let f=t;f<r;f+=t){let p=n[f],m=n[f+1];p<a&&(a=p),m<l&&(l=m),p>u&&(u=p),m>h&&(h=m)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return vl(s,o,t,a,l,c,0),o}function tg(n,e,t,i,r){let s;if(r===Iy(n,e,t,i)>0)for(let o=e;o<t;o+=i)s=eg(o/i|0,n[o],n[o+1],s);else for(let o=t-i;o>=e;o-=i)s=eg(o/i|0,n[o],n[o+1],s);return s&&Ko(s,s.next)&&(Sl(s),s=s.next),s}function Ds(n,e){if(!n)return n;e||(e=n);let t=n,i;do if(i=!1,!t.steiner&&(Ko(t,t.next)||ii(t.prev,t,t.next)===0)){if(Sl(t),t=e=t.prev,t===t.next)break;i=!0}else t=t.next;while(i||t!==e);return e}function vl(n,e,t,i,r,s,o){if(!n)return;!o&&s&&Ay(n,i,r,s);let a=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(s?vy(n,i,r,s):_y(n)){e.push(l.i,n.i,c.i),Sl(n),n=c.next,a=c.next;continue}if(n=c,n===a){o?o===1?(n=My(Ds(n),e),vl(n,e,t,i,r,s,2)):o===2&&Sy(n,e,t,i,r,s):vl(Ds(n),e,t,i,r,s,1);break}}}function _y(n){let e=n.prev,t=n,i=n.next;if(ii(e,t,i)>=0)return!1;let r=e.x,s=t.x,o=i.x,a=e.y,l=t.y,c=i.y,u=Math.min(r,s,o),h=Math.min(a,l,c),f=Math.max(r,s,o),p=Math.max(a,l,c),m=i.next;for(;m!==e;){if(m.x>=u&&m.x<=f&&m.y>=h&&m.y<=p&&_l(r,a,s,l,o,c,m.x,m.y)&&ii(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function vy(n,e,t,i){let r=n.prev,s=n,o=n.next;if(ii(r,s,o)>=0)return!1;let a=r.x,l=s.x,c=o.x,u=r.y,h=s.y,f=o.y,p=Math.min(a,l,c),m=Math.min(u,h,f),M=Math.max(a,l,c),d=Math.max(u,h,f),g=df(p,m,e,t,i),v=df(M,d,e,t,i),T=n.prevZ,S=n.nextZ;for(;T&&T.z>=g&&S&&S.z<=v;){if(T.x>=p&&T.x<=M&&T.y>=m&&T.y<=d&&T!==r&&T!==o&&_l(a,u,l,h,c,f,T.x,T.y)&&ii(T.prev,T,T.next)>=0||(T=T.prevZ,S.x>=p&&S.x<=M&&S.y>=m&&S.y<=d&&S!==r&&S!==o&&_l(a,u,l,h,c,f,S.x,S.y)&&ii(S.prev,S,S.next)>=0))return!1;S=S.nextZ}for(;T&&T.z>=g;){if(T.x>=p&&T.x<=M&&T.y>=m&&T.y<=d&&T!==r&&T!==o&&_l(a,u,l,h,c,f,T.x,T.y)&&ii(T.prev,T,T.next)>=0)return!1;T=T.prevZ}for(;S&&S.z<=v;){if(S.x>=p&&S.x<=M&&S.y>=m&&S.y<=d&&S!==r&&S!==o&&_l(a,u,l,h,c,f,S.x,S.y)&&ii(S.prev,S,S.next)>=0)return!1;S=S.nextZ}return!0}function My(n,e){let t=n;do{let i=t.prev,r=t.next.next;!Ko(i,r)&&ng(i,t,t.next,r)&&Ml(i,r)&&Ml(r,i)&&(e.push(i.i,t.i,r.i),Sl(t),Sl(t.next),t=n=r),t=t.next}while(t!==n);return Ds(t)}function Sy(n,e,t,i,r,s){let o=n;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Py(o,a)){let l=rg(o,a);o=Ds(o,o.next),l=Ds(l,l.next),vl(o,e,t,i,r,s,0),vl(l,e,t,i,r,s,0);return}a=a.next}o=o.next}while(o!==n)}function yy(n,e,t,i){let r=[];for(let s=0,o=e.length;s<o;s++){let a=e[s]*i,l=s<o-1?e[s+1]*i:n.length,c=tg(n,a,l,i,!1);c===c.next&&(c.steiner=!0),r.push(Cy(c))}r.sort(by);for(let s=0;s<r.length;s++)t=Ey(r[s],t);return t}function by(n,e){let t=n.x-e.x;if(t===0&&(t=n.y-e.y,t===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),r=(e.next.y-e.y)/(e.next.x-e.x);t=i-r}return t}function Ey(n,e){let t=wy(n,e);if(!t)return e;let i=rg(t,n);return Ds(i,i.next),Ds(t,t.next)}function wy(n,e){let t=e,i=n.x,r=n.y,s=-1/0,o;if(Ko(n,t))return t;do{if(Ko(n,t.next))return t.next;if(r<=t.y&&r>=t.next.y&&t.next.y!==t.y){let h=t.x+(r-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(h<=i&&h>s&&(s=h,o=t.x<t.next.x?t:t.next,h===i))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,u=1/0;t=o;do{if(i>=t.x&&t.x>=l&&i!==t.x&&ig(r<c?i:s,r,l,c,r<c?s:i,r,t.x,t.y)){let h=Math.abs(r-t.y)/(i-t.x);Ml(t,n)&&(h<u||h===u&&(t.x>o.x||t.x===o.x&&Ty(o,t)))&&(o=t,u=h)}t=t.next}while(t!==a);return o}function Ty(n,e){return ii(n.prev,n,e.prev)<0&&ii(e.next,n,n.next)<0}function Ay(n,e,t,i){let r=n;do r.z===0&&(r.z=df(r.x,r.y,e,t,i)),r.prevZ=r.prev,r.nextZ=r.next,r=r.next;while(r!==n);r.prevZ.nextZ=null,r.prevZ=null,Ry(r)}function Ry(n){let e,t=1;do{let i=n,r;n=null;let s=null;for(e=0;i;){e++;let o=i,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||i.z<=o.z)?(r=i,i=i.nextZ,a--):(r=o,o=o.nextZ,l--),s?s.nextZ=r:n=r,r.prevZ=s,s=r;i=o}s.nextZ=null,t*=2}while(e>1);return n}function df(n,e,t,i,r){return n=(n-t)*r|0,e=(e-i)*r|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,n|e<<1}function Cy(n){let e=n,t=n;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==n);return t}function ig(n,e,t,i,r,s,o,a){return(r-o)*(e-a)>=(n-o)*(s-a)&&(n-o)*(i-a)>=(t-o)*(e-a)&&(t-o)*(s-a)>=(r-o)*(i-a)}function _l(n,e,t,i,r,s,o,a){return!(n===o&&e===a)&&ig(n,e,t,i,r,s,o,a)}function Py(n,e){return n.next.i!==e.i&&n.prev.i!==e.i&&!Ly(n,e)&&(Ml(n,e)&&Ml(e,n)&&Dy(n,e)&&(ii(n.prev,n,e.prev)||ii(n,e.prev,e))||Ko(n,e)&&ii(n.prev,n,n.next)>0&&ii(e.prev,e,e.next)>0)}function ii(n,e,t){return(e.y-n.y)*(t.x-e.x)-(e.x-n.x)*(t.y-e.y)}function Ko(n,e){return n.x===e.x&&n.y===e.y}function ng(n,e,t,i){let r=mu(ii(n,e,t)),s=mu(ii(n,e,i)),o=mu(ii(t,i,n)),a=mu(ii(t,i,e));return!!(r!==s&&o!==a||r===0&&du(n,t,e)||s===0&&du(n,i,e)||o===0&&du(t,n,i)||a===0&&du(t,e,i))}function du(n,e,t){return e.x<=Math.max(n.x,t.x)&&e.x>=Math.min(n.x,t.x)&&e.y<=Math.max(n.y,t.y)&&e.y>=Math.min(n.y,t.y)}function mu(n){return n>0?1:n<0?-1:0}function Ly(n,e){let t=n;do{if(t.i!==n.i&&t.next.i!==n.i&&t.i!==e.i&&t.next.i!==e.i&&ng(t,t.next,n,e))return!0;t=t.next}while(t!==n);return!1}function Ml(n,e){return ii(n.prev,n,n.next)<0?ii(n,e,n.next)>=0&&ii(n,n.prev,e)>=0:ii(n,e,n.prev)<0||ii(n,n.next,e)<0}function Dy(n,e){let t=n,i=!1,r=(n.x+e.x)/2,s=(n.y+e.y)/2;do t.y>s!=t.next.y>s&&t.next.y!==t.y&&r<(t.next.x-t.x)*(s-t.y)/(t.next.y-t.y)+t.x&&(i=!i),t=t.next;while(t!==n);return i}function rg(n,e){let t=mf(n.i,n.x,n.y),i=mf(e.i,e.x,e.y),r=n.next,s=e.prev;return n.next=e,e.prev=n,t.next=r,r.prev=t,i.next=t,t.prev=i,s.next=i,i.prev=s,i}function eg(n,e,t,i){let r=mf(n,e,t);return i?(r.next=i.next,r.prev=i,i.next.prev=r,i.next=r):(r.prev=r,r.next=r),r}function Sl(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function mf(n,e,t){return{i:n,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Iy(n,e,t,i){let r=0;for(let s=e,o=t-i;s<t;s+=i)r+=(n[o]-n[s])*(n[s+1]+n[o+1]),o=s;return r}var gu=class{static triangulate(e,t,i=2){return gf(e,t,i)}};var jn=class n{static area(e){let t=e.length,i=0;for(let r=t-1,s=0;s<t;r=s++)i+=e[r].x*e[s].y-e[s].x*e[r].y;return i*.5}static isClockWise(e){return n.area(e)<0}static triangulateShape(e,t){let i=[],r=[],s=[];sg(e),og(i,e);let o=e.length;t.forEach(sg);for(let l=0;l<t.length;l++)r.push(o),o+=t[l].length,og(i,t[l]);let a=gu.triangulate(i,r);for(let l=0;l<a.length;l+=3)s.push(a.slice(l,l+3));return s}};function sg(n){let e=n.length;e>2&&n[e-1].equals(n[0])&&n.pop()}function og(n,e){for(let t=0;t<e.length;t++)n.push(e[t].x),n.push(e[t].y)}var xu=class n extends zt{constructor(e=new fr([new le(.5,.5),new le(-.5,.5),new le(-.5,-.5),new le(.5,-.5)]),t={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:e,options:t},e=Array.isArray(e)?e:[e];let i=this,r=[],s=[];for(let a=0,l=e.length;a<l;a++){let c=e[a];o(c)}this.setAttribute("position",new mt(r,3)),this.setAttribute("uv",new mt(s,2)),this.computeVertexNormals();function o(a){let l=[],c=t.curveSegments!==void 0?t.curveSegments:12,u=t.steps!==void 0?t.steps:1,h=t.depth!==void 0?t.depth:1,f=t.bevelEnabled!==void 0?t.bevelEnabled:!0,p=t.bevelThickness!==void 0?t.bevelThickness:.2,m=t.bevelSize!==void 0?t.bevelSize:p-.1,M=t.bevelOffset!==void 0?t.bevelOffset:0,d=t.bevelSegments!==void 0?t.bevelSegments:3,g=t.extrudePath,v=t.UVGenerator!==void 0?t.UVGenerator:Uy,T,S=!1,C,A,x,E;if(g){T=g.getSpacedPoints(u),S=!0,f=!1;let se=g.isCatmullRomCurve3?g.closed:!1;C=g.computeFrenetFrames(u,se),A=new O,x=new O,E=new O}f||(d=0,p=0,m=0,M=0);let B=a.extractPoints(c),D=B.shape,L=B.holes;if(!jn.isClockWise(D)){D=D.reverse();for(let se=0,Me=L.length;se<Me;se++){let _e=L[se];jn.isClockWise(_e)&&(L[se]=_e.reverse())}}function W(se){let _e=10000000000000001e-36,Be=se[0];for(let Ie=1;Ie<=se.length;Ie++){let nt=Ie%se.length,ke=se[nt],gt=ke.x-Be.x,pt=ke.y-Be.y,St=gt*gt+pt*pt,F=Math.max(Math.abs(ke.x),Math.abs(ke.y),Math.abs(Be.x),Math.abs(Be.y)),ye=_e*F*F;if(St<=ye){se.splice(nt,1),Ie--;continue}Be=ke}}W(D),L.forEach(W);let I=L.length,H=D;for(let se=0;se<I;se++){let Me=L[se];D=D.concat(Me)}function q(se,Me,_e){return Me||bt("ExtrudeGeometry: vec does not exist"),se.clone().addScaledVector(Me,_e)}let z=D.length;function ce(se,Me,_e){let Be,Ie,nt,ke=se.x-Me.x,gt=se.y-Me.y,pt=_e.x-se.x,St=_e.y-se.y,F=ke*ke+gt*gt,ye=ke*St-gt*pt;if(Math.abs(ye)>Number.EPSILON){let qe=Math.sqrt(F),ht=Math.sqrt(pt*pt+St*St),we=Me.x-gt/qe,Nt=Me.y+ke/qe,$e=_e.x-St/ht,it=_e.y+pt/ht,R=(($e-we)*St-(it-Nt)*pt)/(ke*St-gt*pt);Be=we+ke*R-se.x,Ie=Nt+gt*R-se.y;let y=Be*Be+Ie*Ie;if(y<=2)return new le(Be,Ie);nt=Math.sqrt(y/2)}else{let qe=!1;ke>Number.EPSILON?pt>Number.EPSILON&&(qe=!0):ke<-Number.EPSILON?pt<-Number.EPSILON&&(qe=!0):Math.sign(gt)===Math.sign(St)&&(qe=!0),qe?(Be=-gt,Ie=ke,nt=Math.sqrt(F)):(Be=ke,Ie=gt,nt=Math.sqrt(F/2))}return new le(Be/nt,Ie/nt)}let $=[];for(let se=0,Me=H.length,_e=Me-1,Be=se+1;se<Me;se++,_e++,Be++)_e===Me&&(_e=0),Be===Me&&(Be=0),$[se]=ce(H[se],H[_e],H[Be]);let Q=[],ee,pe=$.concat();for(let se=0,Me=I;se<Me;se++){let _e=L[se];ee=[];for(let Be=0,Ie=_e.length,nt=Ie-1,ke=Be+1;Be<Ie;Be++,nt++,ke++)nt===Ie&&(nt=0),ke===Ie&&(ke=0),ee[Be]=ce(_e[Be],_e[nt],_e[ke]);Q.push(ee),pe=pe.concat(ee)}let ue;if(d===0)ue=jn.triangulateShape(H,L);else{let se=[],Me=[];for(let _e=0;_e<d;_e++){let Be=_e/d,Ie=p*Math.cos(Be*Math.PI/2),nt=m*Math.sin(Be*Math.PI/2)+M;for(let ke=0,gt=H.length;ke<gt;ke++){let pt=q(H[ke],$[ke],nt);He(pt.x,pt.y,-Ie),Be===0&&se.push(pt)}for(let ke=0,gt=I;ke<gt;ke++){let pt=L[ke];ee=Q[ke];let St=[];for(let F=0,ye=pt.length;F<ye;F++){let qe=q(pt[F],ee[F],nt);He(qe.x,qe.y,-Ie),Be===0&&St.push(qe)}Be===0&&Me.push(St)}}ue=jn.triangulateShape(se,Me)}let j=ue.length,xe=m+M;for(let se=0;se<z;se++){let Me=f?q(D[se],pe[se],xe):D[se];S?(x.copy(C.normals[0]).multiplyScalar(Me.x),A.copy(C.binormals[0]).multiplyScalar(Me.y),E.copy(T[0]).add(x).add(A),He(E.x,E.y,E.z)):He(Me.x,Me.y,0)}for(let se=1;se<=u;se++)for(let Me=0;Me<z;Me++){let _e=f?q(D[Me],pe[Me],xe):D[Me];S?(x.copy(C.normals[se]).multiplyScalar(_e.x),A.copy(C.binormals[se]).multiplyScalar(_e.y),E.copy(T[se]).add(x).add(A),He(E.x,E.y,E.z)):He(_e.x,_e.y,h/u*se)}for(let se=d-1;se>=0;se--){let Me=se/d,_e=p*Math.cos(Me*Math.PI/2),Be=m*Math.sin(Me*Math.PI/2)+M;for(let Ie=0,nt=H.length;Ie<nt;Ie++){let ke=q(H[Ie],$[Ie],Be);He(ke.x,ke.y,h+_e)}for(let Ie=0,nt=L.length;Ie<nt;Ie++){let ke=L[Ie];ee=Q[Ie];for(let gt=0,pt=ke.length;gt<pt;gt++){let St=q(ke[gt],ee[gt],Be);S?He(St.x,St.y+T[u-1].y,T[u-1].x+_e):He(St.x,St.y,h+_e)}}}ve(),De();function ve(){let se=r.length/3;if(f){let Me=0,_e=z*Me;for(let Be=0;Be<j;Be++){let Ie=ue[Be];ot(Ie[2]+_e,Ie[1]+_e,Ie[0]+_e)}Me=u+d*2,_e=z*Me;for(let Be=0;Be<j;Be++){let Ie=ue[Be];ot(Ie[0]+_e,Ie[1]+_e,Ie[2]+_e)}}else{for(let Me=0;Me<j;Me++){let _e=ue[Me];ot(_e[2],_e[1],_e[0])}for(let Me=0;Me<j;Me++){let _e=ue[Me];ot(_e[0]+z*u,_e[1]+z*u,_e[2]+z*u)}}i.addGroup(se,r.length/3-se,0)}function De(){let se=r.length/3,Me=0;Ee(H,Me),Me+=H.length;for(let _e=0,Be=L.length;_e<Be;_e++){let Ie=L[_e];Ee(Ie,Me),Me+=Ie.length}i.addGroup(se,r.length/3-se,1)}function Ee(se,Me){let _e=se.length;for(;--_e>=0;){let Be=_e,Ie=_e-1;Ie<0&&(Ie=se.length-1);for(let nt=0,ke=u+d*2;nt<ke;nt++){let gt=z*nt,pt=z*(nt+1),St=Me+Be+gt,F=Me+Ie+gt,ye=Me+Ie+pt,qe=Me+Be+pt;Je(St,F,ye,qe)}}}function He(se,Me,_e){l.push(se),l.push(Me),l.push(_e)}function ot(se,Me,_e){at(se),at(Me),at(_e);let Be=r.length/3,Ie=v.generateTopUV(i,r,Be-3,Be-2,Be-1);rt(Ie[0]),rt(Ie[1]),rt(Ie[2])}function Je(se,Me,_e,Be){at(se),at(Me),at(Be),at(Me),at(_e),at(Be);let Ie=r.length/3,nt=v.generateSideWallUV(i,r,Ie-6,Ie-3,Ie-2,Ie-1);rt(nt[0]),rt(nt[1]),rt(nt[3]),rt(nt[1]),rt(nt[2]),rt(nt[3])}function at(se){r.push(l[se*3+0]),r.push(l[se*3+1]),r.push(l[se*3+2])}function rt(se){s.push(se.x),s.push(se.y)}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes,i=this.parameters.options;return Fy(t,i,e)}static fromJSON(e,t){let i=[];for(let s=0,o=e.shapes.length;s<o;s++){let a=t[e.shapes[s]];i.push(a)}let r=e.options.extrudePath;return r!==void 0&&(e.options.extrudePath=new Yo[r.type]().fromJSON(r)),new n(i,e.options)}},Uy={generateTopUV:function(n,e,t,i,r){let s=e[t*3],o=e[t*3+1],a=e[i*3],l=e[i*3+1],c=e[r*3],u=e[r*3+1];return[new le(s,o),new le(a,l),new le(c,u)]},generateSideWallUV:function(n,e,t,i,r,s){let o=e[t*3],a=e[t*3+1],l=e[t*3+2],c=e[i*3],u=e[i*3+1],h=e[i*3+2],f=e[r*3],p=e[r*3+1],m=e[r*3+2],M=e[s*3],d=e[s*3+1],g=e[s*3+2];return Math.abs(a-u)<Math.abs(o-c)?[new le(o,1-l),new le(c,1-h),new le(f,1-m),new le(M,1-g)]:[new le(a,1-l),new le(u,1-h),new le(p,1-m),new le(d,1-g)]}};function Fy(n,e,t){if(t.shapes=[],Array.isArray(n))for(let i=0,r=n.length;i<r;i++){let s=n[i];t.shapes.push(s.uuid)}else t.shapes.push(n.uuid);return t.options=Object.assign({},e),e.extrudePath!==void 0&&(t.options.extrudePath=e.extrudePath.toJSON()),t}var Fn=class n extends zt{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,u=l+1,h=e/a,f=t/l,p=[],m=[],M=[],d=[];for(let g=0;g<u;g++){let v=g*f-o;for(let T=0;T<c;T++){let S=T*h-s;m.push(S,-v,0),M.push(0,0,1),d.push(T/a),d.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let T=v+c*g,S=v+c*(g+1),C=v+1+c*(g+1),A=v+1+c*g;p.push(T,S,A),p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(M,3)),this.setAttribute("uv",new mt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ns=class n extends zt{constructor(e=.5,t=1,i=32,r=1,s=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:i,phiSegments:r,thetaStart:s,thetaLength:o},i=Math.max(3,i),r=Math.max(1,r);let a=[],l=[],c=[],u=[],h=e,f=(t-e)/r,p=new O,m=new le;for(let M=0;M<=r;M++){for(let d=0;d<=i;d++){let g=s+d/i*o;p.x=h*Math.cos(g),p.y=h*Math.sin(g),l.push(p.x,p.y,p.z),c.push(0,0,1),m.x=(p.x/t+1)/2,m.y=(p.y/t+1)/2,u.push(m.x,m.y)}h+=f}for(let M=0;M<r;M++){let d=M*(i+1);for(let g=0;g<i;g++){let v=g+d,T=v,S=v+i+1,C=v+i+2,A=v+1;a.push(T,S,A),a.push(S,C,A)}}this.setIndex(a),this.setAttribute("position",new mt(l,3)),this.setAttribute("normal",new mt(c,3)),this.setAttribute("uv",new mt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};var _u=class n extends zt{constructor(e=new fr([new le(0,.5),new le(-.5,-.5),new le(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let i=[],r=[],s=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let u=0;u<e.length;u++)c(e[u]),this.addGroup(a,l,u),a+=l,l=0;this.setIndex(i),this.setAttribute("position",new mt(r,3)),this.setAttribute("normal",new mt(s,3)),this.setAttribute("uv",new mt(o,2));function c(u){let h=r.length/3,f=u.extractPoints(t),p=f.shape,m=f.holes;jn.isClockWise(p)===!1&&(p=p.reverse());for(let d=0,g=m.length;d<g;d++){let v=m[d];jn.isClockWise(v)===!0&&(m[d]=v.reverse())}let M=jn.triangulateShape(p,m);for(let d=0,g=m.length;d<g;d++){let v=m[d];p=p.concat(v)}for(let d=0,g=p.length;d<g;d++){let v=p[d];r.push(v.x,v.y,0),s.push(0,0,1),o.push(v.x,v.y)}for(let d=0,g=M.length;d<g;d++){let v=M[d],T=v[0]+h,S=v[1]+h,C=v[2]+h;i.push(T,S,C),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return Ny(t,e)}static fromJSON(e,t){let i=[];for(let r=0,s=e.shapes.length;r<s;r++){let o=t[e.shapes[r]];i.push(o)}return new n(i,e.curveSegments)}};function Ny(n,e){if(e.shapes=[],Array.isArray(n))for(let t=0,i=n.length;t<i;t++){let r=n[t];e.shapes.push(r.uuid)}else e.shapes.push(n.uuid);return e}var $o=class n extends zt{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new O,f=new O,p=[],m=[],M=[],d=[];for(let g=0;g<=i;g++){let v=[],T=g/i,S=o+T*a,C=e*Math.cos(S),A=Math.sqrt(e*e-C*C),x=0;g===0&&o===0?x=.5/t:g===i&&l===Math.PI&&(x=-.5/t);for(let E=0;E<=t;E++){let B=E/t,D=r+B*s;h.x=-A*Math.cos(D),h.y=C,h.z=A*Math.sin(D),m.push(h.x,h.y,h.z),f.copy(h).normalize(),M.push(f.x,f.y,f.z),d.push(B+x,1-T),v.push(c++)}u.push(v)}for(let g=0;g<i;g++)for(let v=0;v<t;v++){let T=u[g][v+1],S=u[g][v],C=u[g+1][v],A=u[g+1][v+1];(g!==0||o>0)&&p.push(T,S,A),(g!==i-1||l<Math.PI)&&p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(M,3)),this.setAttribute("uv",new mt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Lr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(ag(r))r.isRenderTargetTexture?(Xe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(ag(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function qi(n){let e={};for(let t=0;t<n.length;t++){let i=Lr(n[t]);for(let r in i)e[r]=i[r]}return e}function ag(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function lg(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function vu(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var cg={clone:Lr,merge:qi};var ug=`
void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}
`;var hg=`
void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}
`;var hi=class extends In{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ug,this.fragmentShader=hg,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Lr(e.uniforms),this.uniformsGroups=lg(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new tt().setHex(r.value);break;case"v2":this.uniforms[i].value=new le().fromArray(r.value);break;case"v3":this.uniforms[i].value=new O().fromArray(r.value);break;case"v4":this.uniforms[i].value=new It().fromArray(r.value);break;case"m3":this.uniforms[i].value=new et().fromArray(r.value);break;case"m4":this.uniforms[i].value=new st().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}};var Mu=class extends hi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yn=class extends In{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new tt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new tt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=al,this.normalScale=new le(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=ao,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Su=class extends In{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=dm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}};var yu=class extends In{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Zo=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new tt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var yl=class extends Zo{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new tt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var xf=new st,fg=new O,pg=new O,bu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new le(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new st,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Qn,this._frameExtents=new le(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;fg.setFromMatrixPosition(e.matrixWorld),t.position.copy(fg),pg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(pg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){xf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(xf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===Er||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(xf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Eu=new O,wu=new Ii,pr=new O,Jo=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new st,this.projectionMatrix=new st,this.projectionMatrixInverse=new st,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Eu,wu,pr),pr.x===1&&pr.y===1&&pr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Eu,wu,pr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Eu,wu,pr),pr.x===1&&pr.y===1&&pr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Eu,wu,pr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}};var rs=new O,dg=new le,mg=new le,Fi=class extends Jo{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ll*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Nc*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ll*2*Math.atan(Math.tan(Nc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){rs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(rs.x,rs.y).multiplyScalar(-e/rs.z),rs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(rs.x,rs.y).multiplyScalar(-e/rs.z)}getViewSize(e,t){return this.getViewBounds(e,dg,mg),t.subVectors(mg,dg)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Nc*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Qo=class extends Jo{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Tu=class extends bu{constructor(){super(new Qo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}};var bl=class extends Zo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new Tu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var jo=-90,ea=1,Is=class extends Qt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Fi(jo,ea,e,t);r.layers=this.layers,this.add(r);let s=new Fi(jo,ea,e,t);s.layers=this.layers,this.add(s);let o=new Fi(jo,ea,e,t);o.layers=this.layers,this.add(o);let a=new Fi(jo,ea,e,t);a.layers=this.layers,this.add(a);let l=new Fi(jo,ea,e,t);l.layers=this.layers,this.add(l);let c=new Fi(jo,ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Er)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=M,e.setRenderTarget(i,5,r),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}};var Au=class extends Fi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};function _f(n,e,t,i){let r=Oy(i);switch(t){case Pc:return n*e;case fo:return n*e/r.components*r.byteLength;case po:return n*e/r.components*r.byteLength;case gn:return n*e*2/r.components*r.byteLength;case mo:return n*e*2/r.components*r.byteLength;case Lc:return n*e*3/r.components*r.byteLength;case Hi:return n*e*4/r.components*r.byteLength;case go:return n*e*4/r.components*r.byteLength;case xo:case _o:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case vo:case Mo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Da:case Ua:return Math.max(n,16)*Math.max(e,8)/4;case La:case Ia:return Math.max(n,8)*Math.max(e,8)/2;case Fa:case Na:case Ba:case ka:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Oa:case Ms:case Ga:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case za:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ha:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Va:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Wa:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Xa:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case qa:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ya:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ka:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case $a:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Za:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ja:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Qa:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case ja:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case el:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case tl:case il:case nl:return Math.ceil(n/4)*Math.ceil(e/4)*16;case rl:case sl:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ss:case ol:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Oy(n){switch(n){case ui:case Tc:return{byteLength:1,components:1};case br:case Ac:case Di:return{byteLength:2,components:1};case uo:case ho:return{byteLength:2,components:4};case Li:case co:case bi:return{byteLength:4,components:1};case Rc:case Cc:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Xe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ru(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function gg(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<h.length;p++){let m=h[f],M=h[p];M.start<=m.start+m.count+1?m.count=Math.max(m.count,M.start+M.count-m.start):(++f,h[f]=M)}h.length=f+1;for(let p=0,m=h.length;p<m;p++){let M=h[p];n.bufferSubData(c,M.start*u.BYTES_PER_ELEMENT,u,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var xg=`
#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif
`;var _g=`
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
`;var vg=`
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif
`;var Mg=`
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif
`;var Sg=`
#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif
`;var yg=`
#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif
`;var bg=`
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
`;var Eg=`
#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif
`;var wg=`
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
`;var Tg=`
#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif
`;var Ag=`
vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif
`;var Rg=`
vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif
`;var Cg=`
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
`;var Pg="";var Lg=`
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
`;var Dg=`
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
`;var Ig=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif
`;var Ug=`
#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif
`;var Fg=`
#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif
`;var Ng=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif
`;var Og=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif
`;var Bg=`
#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif
`;var kg=`
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
`;var Gg=`
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
`;var zg=`
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
`;var Hg=`
#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif
`;var Vg=`
#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif
`;var Wg=`
#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif
`;var Xg=`
#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif
`;var qg=`
gl_FragColor = linearToOutputTexel( gl_FragColor );
`;var Yg=`
vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}
`;var Kg=`
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
`;var $g=`
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
`;var Zg=`
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
`;var Jg=`
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
`;var Qg=`
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
`;var jg=`
#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif
`;var e0=`
#ifdef USE_FOG
varying float vFogDepth;
#endif
`;var t0=`
#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif
`;var i0=`
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
`;var n0=`
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
`;var r0=`
#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif
`;var s0=`
LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;
`;var o0=`
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
`;var a0=`
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
`;var l0="";var c0="";var u0="";var h0="";var f0="";var p0="";var d0="";var m0=`
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
`;var g0=`
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
`;var x0=`
#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
`;var _0=`
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
`;var v0=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif
`;var M0=`
#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var S0=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif
`;var y0=`
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif
`;var b0=`
#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif
`;var E0=`
#ifdef USE_MAP
uniform sampler2D map;
#endif
`;var w0=`
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
`;var T0=`
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
`;var A0=`
float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif
`;var R0=`
#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif
`;var C0=`
#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] = texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif
`;var P0=`
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
`;var L0=`
#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var D0=`
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
`;var I0=`
#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif
`;var U0=`
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
`;var F0=`
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
`;var N0=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var O0=`
#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif
`;var B0=`
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
`;var k0=`
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
`;var G0="";var z0="";var H0="";var V0="";var W0=`
#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );
`;var X0=`
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
`;var q0=`
#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif
`;var Y0=`
vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;
`;var K0=`
#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif
`;var $0=`
#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif
`;var Z0=`
float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif
`;var J0=`
#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif
`;var Q0=`
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
`;var j0=`
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
`;var ex=`
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
`;var tx=`
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
`;var ix=`
#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif
`;var nx=`
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
`;var rx=`
#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif
`;var sx=`
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
`;var ox=`
float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif
`;var ax=`
#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif
`;var lx=`
#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif
`;var cx=`
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
`;var ux="";var hx="";var fx=`
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
`;var px=`
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
`;var dx=`
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
`;var mx=`
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
`;var gx=`
varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}
`,xx=`
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
`;var _x=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,vx=`
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
`;var Mx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}
`,Sx=`
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
`;var yx=`
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
`,bx=`
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
`;var Ex=`
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
`,wx=`
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
`;var Tx=`
varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}
`,Ax=`
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
`;var Rx=`
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
`,Cx=`
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
`;var Px=`
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
`,Lx=`
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
`;var Dx=`
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
`,Ix=`
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
`;var Ux=`
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
`,Fx=`
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
`;var Nx=`
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
`,Ox=`
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
`;var Bx=`
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
`,kx=`
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
`;var Gx=`
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
`,zx=`
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
`;var vt={alphahash_fragment:xg,alphahash_pars_fragment:_g,alphamap_fragment:vg,alphamap_pars_fragment:Mg,alphatest_fragment:Sg,alphatest_pars_fragment:yg,aomap_fragment:bg,aomap_pars_fragment:Eg,batching_pars_vertex:wg,batching_vertex:Tg,begin_vertex:Ag,beginnormal_vertex:Rg,bsdfs:Cg,iridescence_fragment:Pg,bumpmap_pars_fragment:Lg,clipping_planes_fragment:Dg,clipping_planes_pars_fragment:Ig,clipping_planes_pars_vertex:Ug,clipping_planes_vertex:Fg,color_fragment:Ng,color_pars_fragment:Og,color_pars_vertex:Bg,color_vertex:kg,common:Gg,defaultnormal_vertex:zg,displacementmap_pars_vertex:Hg,displacementmap_vertex:Vg,emissivemap_fragment:Wg,emissivemap_pars_fragment:Xg,colorspace_fragment:qg,colorspace_pars_fragment:Yg,envmap_fragment:Kg,envmap_common_pars_fragment:$g,envmap_pars_fragment:Zg,envmap_pars_vertex:Jg,envmap_physical_pars_fragment:l0,envmap_vertex:Qg,fog_vertex:jg,fog_pars_vertex:e0,fog_fragment:t0,fog_pars_fragment:i0,gradientmap_pars_fragment:n0,lightmap_pars_fragment:r0,lights_lambert_fragment:s0,lights_lambert_pars_fragment:o0,lights_pars_begin:a0,lights_toon_fragment:c0,lights_toon_pars_fragment:u0,lights_phong_fragment:h0,lights_phong_pars_fragment:f0,lights_physical_fragment:p0,lights_physical_pars_fragment:d0,lights_fragment_begin:m0,lights_fragment_maps:g0,lights_fragment_end:x0,lightprobes_pars_fragment:_0,logdepthbuf_fragment:v0,logdepthbuf_pars_fragment:M0,logdepthbuf_pars_vertex:S0,logdepthbuf_vertex:y0,map_fragment:b0,map_pars_fragment:E0,map_particle_fragment:w0,map_particle_pars_fragment:T0,metalnessmap_fragment:A0,metalnessmap_pars_fragment:R0,morphinstance_vertex:C0,morphcolor_vertex:P0,morphnormal_vertex:L0,morphtarget_pars_vertex:D0,morphtarget_vertex:I0,normal_fragment_begin:U0,normal_fragment_maps:F0,normal_pars_fragment:N0,normal_pars_vertex:O0,normal_vertex:B0,normalmap_pars_fragment:k0,clearcoat_normal_fragment_begin:G0,clearcoat_normal_fragment_maps:z0,clearcoat_pars_fragment:H0,iridescence_pars_fragment:V0,opaque_fragment:W0,packing:X0,premultiplied_alpha_fragment:q0,project_vertex:Y0,dithering_fragment:K0,dithering_pars_fragment:$0,roughnessmap_fragment:Z0,roughnessmap_pars_fragment:J0,shadowmap_pars_fragment:Q0,shadowmap_pars_vertex:j0,shadowmap_vertex:ex,shadowmask_pars_fragment:tx,skinbase_vertex:ix,skinning_pars_vertex:nx,skinning_vertex:rx,skinnormal_vertex:sx,specularmap_fragment:ox,specularmap_pars_fragment:ax,tonemapping_fragment:lx,tonemapping_pars_fragment:cx,transmission_fragment:ux,transmission_pars_fragment:hx,uv_pars_fragment:fx,uv_pars_vertex:px,uv_vertex:dx,worldpos_vertex:mx,background_vert:gx,background_frag:xx,backgroundCube_vert:_x,backgroundCube_frag:vx,cube_vert:Mx,cube_frag:Sx,depth_vert:yx,depth_frag:bx,distance_vert:Ex,distance_frag:wx,equirect_vert:Tx,equirect_frag:Ax,linedashed_vert:Rx,linedashed_frag:Cx,meshbasic_vert:Px,meshbasic_frag:Lx,meshlambert_vert:Dx,meshlambert_frag:Ix,meshmatcap_vert:"",meshmatcap_frag:"",meshnormal_vert:Ux,meshnormal_frag:Fx,meshphong_vert:"",meshphong_frag:"",meshphysical_vert:"",meshphysical_frag:"",meshtoon_vert:"",meshtoon_frag:"",points_vert:Nx,points_frag:Ox,shadow_vert:Bx,shadow_frag:kx,sprite_vert:Gx,sprite_frag:zx};var Ne={common:{diffuse:{value:new tt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new le(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new tt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new tt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new tt(16777215)},opacity:{value:1},center:{value:new le(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}};var Nn={basic:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:vt.meshbasic_vert,fragmentShader:vt.meshbasic_frag},lambert:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},envMapIntensity:{value:1}}]),vertexShader:vt.meshlambert_vert,fragmentShader:vt.meshlambert_frag},phong:{uniforms:qi([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},specular:{value:new tt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:vt.meshphong_vert,fragmentShader:vt.meshphong_frag},standard:{uniforms:qi([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag},toon:{uniforms:qi([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new tt(0)}}]),vertexShader:vt.meshtoon_vert,fragmentShader:vt.meshtoon_frag},matcap:{uniforms:qi([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:vt.meshmatcap_vert,fragmentShader:vt.meshmatcap_frag},points:{uniforms:qi([Ne.points,Ne.fog]),vertexShader:vt.points_vert,fragmentShader:vt.points_frag},dashed:{uniforms:qi([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:vt.linedashed_vert,fragmentShader:vt.linedashed_frag},depth:{uniforms:qi([Ne.common,Ne.displacementmap]),vertexShader:vt.depth_vert,fragmentShader:vt.depth_frag},normal:{uniforms:qi([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:vt.meshnormal_vert,fragmentShader:vt.meshnormal_frag},sprite:{uniforms:qi([Ne.sprite,Ne.fog]),vertexShader:vt.sprite_vert,fragmentShader:vt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:vt.background_vert,fragmentShader:vt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:vt.backgroundCube_vert,fragmentShader:vt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:vt.cube_vert,fragmentShader:vt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:vt.equirect_vert,fragmentShader:vt.equirect_frag},distance:{uniforms:qi([Ne.common,Ne.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:vt.distance_vert,fragmentShader:vt.distance_frag},shadow:{uniforms:qi([Ne.lights,Ne.fog,{color:{value:new tt(0)},opacity:{value:1}}]),vertexShader:vt.shadow_vert,fragmentShader:vt.shadow_frag}};Nn.physical={uniforms:qi([Nn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new le(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new tt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new le},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new tt(0)},specularColor:{value:new tt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new le},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag};var Cu={r:0,b:0,g:0},Jy=new st,Hx=new et;Hx.set(-1,0,0,0,1,0,0,0,1);function Vx(n,e,t,i,r,s){let o=new tt(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function p(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function m(v){let T=!1,S=p(v);S===null?d(o,a):S&&S.isColor&&(d(S,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,s):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(v,T){let S=p(T);S&&S.isCubeTexture?(c===void 0&&(c=new At(new ts(1,1,1),new hi({name:"BackgroundCubeMaterial",uniforms:Lr(Nn.backgroundCube.uniforms),vertexShader:Nn.backgroundCube.vertexShader,fragmentShader:Nn.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Jy.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Hx),c.material.toneMapped=_t.getTransfer(S.colorSpace)!==Pt,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new At(new Fn(2,2),new hi({name:"BackgroundMaterial",uniforms:Lr(Nn.background.uniforms),vertexShader:Nn.background.vertexShader,fragmentShader:Nn.background.fragmentShader,side:An,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=_t.getTransfer(S.colorSpace)!==Pt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function d(v,T){v.getRGB(Cu,vu(n)),t.buffers.color.setClear(Cu.r,Cu.g,Cu.b,T,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:m,addToRenderList:M,dispose:g}}function Wx(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(L,G,W,I,H){let q=!1,z=h(L,I,W,G);s!==z&&(s=z,c(s.object)),q=p(L,I,W,H),q&&m(L,I,W,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,S(L,G,W,I),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,G,W,I){let H=I.wireframe===!0,q=i[G.id];q===void 0&&(q={},i[G.id]=q);let z=L.isInstancedMesh===!0?L.id:0,ce=q[z];ce===void 0&&(ce={},q[z]=ce);let $=ce[W.id];$===void 0&&($={},ce[W.id]=$);let Q=$[H];return Q===void 0&&(Q=f(l()),$[H]=Q),Q}function f(L){let G=[],W=[],I=[];for(let H=0;H<t;H++)G[H]=0,W[H]=0,I[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:I,object:L,attributes:{},index:null}}function p(L,G,W,I){let H=s.attributes,q=G.attributes,z=0,ce=W.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ee=H[$],pe=q[$];if(pe===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(pe=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(pe=L.instanceColor)),ee===void 0||ee.attribute!==pe||pe&&ee.data!==pe.data)return!0;z++}return s.attributesNum!==z||s.index!==I}function m(L,G,W,I){let H={},q=G.attributes,z=0,ce=W.getAttributes();for(let $ in ce)if(ce[$].location>=0){let ee=q[$];ee===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor));let pe={};pe.attribute=ee,ee&&ee.data&&(pe.data=ee.data),H[$]=pe,z++}s.attributes=H,s.attributesNum=z,s.index=I}function M(){let L=s.newAttributes;for(let G=0,W=L.length;G<W;G++)L[G]=0}function d(L){g(L,0)}function g(L,G){let W=s.newAttributes,I=s.enabledAttributes,H=s.attributeDivisors;W[L]=1,I[L]===0&&(n.enableVertexAttribArray(L),I[L]=1),H[L]!==G&&(n.vertexAttribDivisor(L,G),H[L]=G)}function v(){let L=s.newAttributes,G=s.enabledAttributes;for(let W=0,I=G.length;W<I;W++)G[W]!==L[W]&&(n.disableVertexAttribArray(W),G[W]=0)}function T(L,G,W,I,H,q,z){z===!0?n.vertexAttribIPointer(L,G,W,H,q):n.vertexAttribPointer(L,G,W,I,H,q)}function S(L,G,W,I){M();let H=I.attributes,q=W.getAttributes(),z=G.defaultAttributeValues;for(let ce in q){let $=q[ce];if($.location>=0){let Q=H[ce];if(Q===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ee=Q.normalized,pe=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let j=ue.buffer,xe=ue.type,ve=ue.bytesPerElement,De=xe===n.INT||xe===n.UNSIGNED_INT||Q.gpuType===co;if(Q.isInterleavedBufferAttribute){let Ee=Q.data,He=Ee.isInterleavedBuffer===!0?Ee.stride:Ee.itemSize,ot=Q.offset;if(Ee.isInstancedInterleavedBuffer||Ee.isInstancedBufferAttribute){for(let Je=0;Je<$.locationSize;Je++)g($.location+Je,Ee.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Ee.meshPerAttribute*Ee.count)}else for(let Je=0;Je<$.locationSize;Je++)d($.location+Je);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Je=0;Je<$.locationSize;Je++)T($.location+Je,pe/$.locationSize,xe,ee,He*ve,(ot+pe/$.locationSize*Je)*ve,De)}else{if(Q.isInstancedBufferAttribute){for(let Ee=0;Ee<$.locationSize;Ee++)g($.location+Ee,Q.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Ee=0;Ee<$.locationSize;Ee++)d($.location+Ee);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Ee=0;Ee<$.locationSize;Ee++)T($.location+Ee,pe/$.locationSize,xe,ee,pe*ve,pe/$.locationSize*Ee*ve,De)}}else if(z!==void 0){let ee=z[ce];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv($.location,ee);break;case 3:n.vertexAttrib3fv($.location,ee);break;case 4:n.vertexAttrib4fv($.location,ee);break;default:n.vertexAttrib1fv($.location,ee)}}}}v()}function C(){B();for(let L in i){let G=i[L];for(let W in G){let I=G[W];for(let H in I){let q=I[H];for(let z in q)u(q[z].object),delete q[z];delete I[H]}}delete i[L]}}function A(L){if(i[L.id]===void 0)return;let G=i[L.id];for(let W in G){let I=G[W];for(let H in I){let q=I[H];for(let z in q)u(q[z].object),delete q[z];delete I[H]}}delete i[L.id]}function x(L){for(let G in i){let W=i[G];for(let I in W){let H=W[I];if(H[L.id]===void 0)continue;let q=H[L.id];for(let z in q)u(q[z].object),delete q[z];delete H[L.id]}}}function E(L){for(let G in i){let W=i[G],I=L.isInstancedMesh===!0?L.id:0,H=W[I];if(H!==void 0){for(let q in H){let z=H[q];for(let ce in z)u(z[ce].object),delete z[ce];delete H[q]}delete W[I],Object.keys(W).length===0&&delete i[G]}}}function B(){D(),o=!0,s!==r&&(s=r,c(s.object))}function D(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:B,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:d,disableUnusedAttributes:v}}function Xx(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function qx(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(x){return!(x!==Hi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Di&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ui&&x!==bi&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Xe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Xe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Xe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:p,maxVertexTextures:m,maxTextureSize:M,maxCubemapSize:d,maxAttributes:g,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function Yx(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Mn,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||r;return r=f,i=h.length,p},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let m=h.clippingPlanes,M=h.clipIntersection,d=h.clipShadows,g=n.get(h);if(!r||m===null||m.length===0||s&&!d)s?u(null):c();else{let v=s?0:i,T=v*4,S=g.clippingState||null;l.value=S,S=u(m,f,T,p);for(let C=0;C!==T;++C)S[C]=t[C];g.clippingState=S,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,p,m){let M=h!==null?h.length:0,d=null;if(M!==0){if(d=l.value,m!==!0||d===null){let g=p+M*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<g)&&(d=new Float32Array(g));for(let T=0,S=p;T!==M;++T,S+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(d,S),d[S+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,d}}var ss=class extends Gi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Go(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new ts(5,5,5),s=new hi({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ei,blending:cr});s.uniforms.tEquirect.value=t;let o=new At(r,s),a=t.minFilter;return t.minFilter===dn&&(t.minFilter=xi),new Is(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}};var Kx=256,Qy=3,jy=20,Qx=256,jx=16,eb=3,tb=new O,ib=new tt,El=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Is(1,10,null),this._boxMesh=new At(new ts(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=tb}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,M=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(e.background=l.getClearColor(ib));let d=new Is(i,r,u);return d.position.copy(a),d.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=m,e.background=M,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Jx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Zx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Kx,Lm(e))}_fromTexture(e,t){e.mapping===ur||e.mapping===qr?this._setSize(e.image.length===0?Kx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=$x(e,!1,!1),i=Math.log2(e)-Qy;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=$x(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ur||e.mapping===qr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Jx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Zx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=nb(),this._integrationMaterial=rb());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/jx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-eb)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Qx*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=sb());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function $x(n,e,t){return new ss(n,{minFilter:dn,generateMipmaps:e,type:Di,colorSpace:ys,depthBuffer:t})}function wl(n,e,t){return new hi({name:n,uniforms:e,vertexShader:vt.cube_vert,fragmentShader:t,side:ei,blending:cr,depthTest:!1,depthWrite:!1})}function nb(){return wl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Qx}u

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
	`)}function rb(){return wl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:jx}},`

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
	`)}function sb(){return wl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${jy}
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
	`)}function Zx(){return wl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Jx(){return wl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function e_(n){let e=new WeakMap,t=new WeakMap,i=null;function r(f,p=!1){return f==null?null:p?o(f):s(f)}function s(f){if(f&&f.isTexture){let p=f.mapping;if(p===bc||p===Ec)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let M=new ss(m.height);return M.fromEquirectangularTexture(n,f),e.set(f,M),f.addEventListener("dispose",c),a(M.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,m=p===bc||p===Ec,M=p===ur||p===qr;if(m||M){let d=t.get(f),g=d!==void 0?d.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new El(n)),d=m?i.fromEquirectangular(f,d):i.fromCubemap(f,d),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),d.texture;if(d!==void 0)return d.texture;{let v=f.image;return m&&v&&v.height>0||M&&v&&l(v)?(i===null&&(i=new El(n)),d=m?i.fromEquirectangular(f):i.fromCubemap(f),d.texture.pmremVersion=f.pmremVersion,t.set(f,d),f.addEventListener("dispose",u),d.texture):null}}}return f}function a(f,p){return p===bc?f.mapping=ur:p===Ec&&(f.mapping=qr),f}function l(f){let p=0,m=6;for(let M=0;M<m;M++)f[M]!==void 0&&p++;return p===m}function c(f){let p=f.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:h}}function t_(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&Es("WebGLRenderer: "+i+" extension not supported."),r}}}function i_(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let d in m.attributes)e.remove(m.attributes[d]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let M=s.get(m);M&&(e.remove(M),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,M){return r[M.id]!==void 0||(M.addEventListener("dispose",a),r[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function u(m){let M=m.attributes;for(let d in M)e.update(M[d],n.ARRAY_BUFFER)}function h(m){let M=m.index,d=m.attributes.position,g=0;if(d===void 0)return;let v=M!==null?M.array.length:d.array.length/3-1,T=d.count>=65535?No:Fo,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(M!==null){let x=M.array;g=M.version;for(let E=0,B=0;E<v;E+=3){let D=x[E+0],L=x[E+1],G=x[E+2];C[B++]=D,C[B++]=L,C[B++]=L,C[B++]=G,C[B++]=G,C[B++]=D}}else{g=d.version;for(let x=0,E=0;x<v;x+=3){let B=x+0,D=x+1,L=x+2;C[E++]=B,C[E++]=D,C[E++]=D,C[E++]=L,C[E++]=L,C[E++]=B}}S.version=g;let A=s.get(m);A&&e.remove(A),s.set(m,S)}function f(m){let M=s.get(m);if(M){let d=m.index;d!==null&&M.version<d.version&&h(m)}else h(m);return s.get(m)}function p(){for(let m in r){let M=r[m].deref();M!==void 0&&l(M)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function n_(n,e,t){let i;function r(h){i=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,s,h*o),t.update(f,i,1)}function c(h,f,p){p!==0&&(n.drawElementsInstanced(i,f,s,h*o,p),t.update(f,i,p))}function u(h,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,h,0,p);let M=0;for(let d=0;d<p;d++)M+=f[d];t.update(M,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function r_(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:bt("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function s_(n,e,t){let i=new WeakMap,r=new It;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let B=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",B)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;p===!0&&(T=1),m===!0&&(T=2),M===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*C*4*h),x=new Eo(A,S,C,h);x.type=bi,x.needsUpdate=!0;let E=T*4;for(let D=0;D<h;D++){let L=d[D],G=g[D],W=v[D],I=S*C*4*D;for(let H=0;H<L.count;H++){let q=H*E;p===!0&&(r.fromBufferAttribute(L,H),A[I+q+0]=r.x,A[I+q+1]=r.y,A[I+q+2]=r.z,A[I+q+3]=0),m===!0&&(r.fromBufferAttribute(G,H),A[I+q+4]=r.x,A[I+q+5]=r.y,A[I+q+6]=r.z,A[I+q+7]=0),M===!0&&(r.fromBufferAttribute(W,H),A[I+q+8]=r.x,A[I+q+9]=r.y,A[I+q+10]=r.z,A[I+q+11]=W.itemSize===4?r.w:1)}}f={count:h,texture:x,size:new le(S,C)},i.set(a,f),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let M=0;M<c.length;M++)p+=c[M];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:s}}function o_(n,e,t,i,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=e.get(c,h);if(s.get(f)!==u&&(e.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==u&&(p.update(),s.set(p,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ob={[xc]:"LINEAR_TONE_MAPPING",[_c]:"REINHARD_TONE_MAPPING",[vc]:"CINEON_TONE_MAPPING",[Mc]:"ACES_FILMIC_TONE_MAPPING",[yc]:"AGX_TONE_MAPPING",[lo]:"NEUTRAL_TONE_MAPPING",[Sc]:"CUSTOM_TONE_MAPPING"};function a_(n,e,t,i,r,s){let o=new Gi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new zt;u.setAttribute("position",new mt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new mt([0,2,0,0,2,0],2));let h=new Mu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new At(u,h),p=new Qo(-1,1,1,-1,0,1),m=null,M=null,d=!1,g,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let x=0;x<T.length;x++){let E=T[x];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,x=o.height;T.length>0&&a===null&&(a=new Gi(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new Gi(A,x,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let E=r===!0&&T.some(B=>B.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Sn(A,x),s===!0&&(c.format=mn,c.type=Xn)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let B=0;B<T.length;B++){let D=T[B];D.setSize&&D.setSize(A,x),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(C,A){if(d||C.toneMapping===pn&&T.length===0)return!1;if(v=A,A!==null){let x=A.width,E=A.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=pn,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=g,d=!0;let x=o,E=a;for(let B=0;B<T.length;B++){let D=T[B];D.enabled!==!1&&(D.render(C,E,x,A),D.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(m!==C.outputColorSpace||M!==C.toneMapping){m=C.outputColorSpace,M=C.toneMapping,h.defines={},_t.getTransfer(m)===Pt&&(h.defines.SRGB_TRANSFER="");let B=ob[M];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(f,p),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var d_=new ti,m_=new Sn(1,1),g_=new zo(1),x_=new Eo,__=new zc,v_=new Go,l_=[],c_=[],u_=new Float32Array(16),h_=new Float32Array(9),f_=new Float32Array(4);function ta(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=l_[r];if(s===void 0&&(s=new Float32Array(r),l_[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function wi(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ti(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Pu(n,e){let t=c_[e];t===void 0&&(t=new Int32Array(e),c_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function ab(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function lb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2fv(this.addr,e),Ti(t,e)}}function cb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wi(t,e))return;n.uniform3fv(this.addr,e),Ti(t,e)}}function ub(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4fv(this.addr,e),Ti(t,e)}}function hb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;f_.set(i),n.uniformMatrix2fv(this.addr,!1,f_),Ti(t,i)}}function fb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;h_.set(i),n.uniformMatrix3fv(this.addr,!1,h_),Ti(t,i)}}function pb(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wi(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ti(t,e)}else{if(wi(t,i))return;u_.set(i),n.uniformMatrix4fv(this.addr,!1,u_),Ti(t,i)}}function db(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function mb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2iv(this.addr,e),Ti(t,e)}}function gb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wi(t,e))return;n.uniform3iv(this.addr,e),Ti(t,e)}}function xb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4iv(this.addr,e),Ti(t,e)}}function _b(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function vb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wi(t,e))return;n.uniform2uiv(this.addr,e),Ti(t,e)}}function Mb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wi(t,e))return;n.uniform3uiv(this.addr,e),Ti(t,e)}}function Sb(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wi(t,e))return;n.uniform4uiv(this.addr,e),Ti(t,e)}}function Lu(n){return n.version===0&&(n.compareFunction=Fc,n.needsUpdate=!0),n}function yb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Lu(m_):s=d_,t.setTexture2D(e||s,r)}function bb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||__,r)}function Eb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Lu(g_):s=v_,t.setTextureCube(e||s,r)}function wb(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||x_,r)}function Tb(n){switch(n){case 5126:return ab;case 35664:return lb;case 35665:return cb;case 35666:return ub;case 35674:return hb;case 35675:return fb;case 35676:return pb;case 5124:case 35670:return db;case 35667:case 35671:return mb;case 35668:case 35672:return gb;case 35669:case 35673:return xb;case 5125:return _b;case 36294:return vb;case 36295:return Mb;case 36296:return Sb;case 35678:case 36198:case 36298:case 36306:case 35682:return yb;case 35679:case 36299:case 36307:return bb;case 35680:case 36300:case 36308:case 36293:return Eb;case 36289:case 36303:case 36311:case 36292:return wb}}function Ab(n,e){n.uniform1fv(this.addr,e)}function Rb(n,e){let t=ta(e,this.size,2);n.uniform2fv(this.addr,t)}function Cb(n,e){let t=ta(e,this.size,3);n.uniform3fv(this.addr,t)}function Pb(n,e){let t=ta(e,this.size,4);n.uniform4fv(this.addr,t)}function Lb(n,e){let t=ta(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Db(n,e){let t=ta(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Ib(n,e){let t=ta(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Ub(n,e){n.uniform1iv(this.addr,e)}function Fb(n,e){n.uniform2iv(this.addr,e)}function Nb(n,e){n.uniform3iv(this.addr,e)}function Ob(n,e){n.uniform4iv(this.addr,e)}function Bb(n,e){n.uniform1uiv(this.addr,e)}function kb(n,e){n.uniform2uiv(this.addr,e)}function Gb(n,e){n.uniform3uiv(this.addr,e)}function zb(n,e){n.uniform4uiv(this.addr,e)}function Hb(n,e,t){let i=this.cache,r=e.length,s=Pu(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Lu(m_):o=d_;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function Vb(n,e,t){let i=this.cache,r=e.length,s=Pu(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||__,s[o])}function Wb(n,e,t){let i=this.cache,r=e.length,s=Pu(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Lu(g_):o=v_;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function Xb(n,e,t){let i=this.cache,r=e.length,s=Pu(t,r);wi(i,s)||(n.uniform1iv(this.addr,s),Ti(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||x_,s[o])}function qb(n){switch(n){case 5126:return Ab;case 35664:return Rb;case 35665:return Cb;case 35666:return Pb;case 35674:return Lb;case 35675:return Db;case 35676:return Ib;case 5124:case 35670:return Ub;case 35667:case 35671:return Fb;case 35668:case 35672:return Nb;case 35669:case 35673:return Ob;case 5125:return Bb;case 36294:return kb;case 36295:return Gb;case 36296:return zb;case 35678:case 36198:case 36298:case 36306:case 35682:return Hb;case 35679:case 36299:case 36307:return Vb;case 35680:case 36300:case 36308:case 36293:return Wb;case 36289:case 36303:case 36311:case 36292:return Xb}}var Sf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Tb(t.type)}},yf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=qb(t.type)}},bf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},Mf=/(\w+)(\])?(\[|\.)?/g;function p_(n,e){n.seq.push(e),n.map[e.id]=e}function Yb(n,e,t){let i=n.name,r=i.length;for(Mf.lastIndex=0;;){let s=Mf.exec(i),o=Mf.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){p_(t,c===void 0?new Sf(a,n,e):new yf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new bf(a),p_(t,h)),t=h}}}var os=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Yb(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Ef(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Kb=37297,$b=0;function Zb(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var M_=new et;function Jb(n){_t._getMatrix(M_,_t.workingColorSpace,n);let e=`mat3( ${M_.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case bs:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Xe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function S_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+Zb(n.getShaderSource(e),a)}else return s}function Qb(n,e){let t=Jb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var jb={[xc]:"Linear",[_c]:"Reinhard",[vc]:"Cineon",[Mc]:"ACESFilmic",[yc]:"AgX",[lo]:"Neutral",[Sc]:"Custom"};function eE(n,e){let t=jb[e];return t===void 0?(Xe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Du=new O;function tE(){_t.getLuminanceCoefficients(Du);let n=Du.x.toFixed(4),e=Du.y.toFixed(4),t=Du.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function iE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function nE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function rE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Tl(n){return n!==""}function y_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function b_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var sE=/^[ \t]*#include +<([\w\d./]+)>/gm;function wf(n){return n.replace(sE,oE)}function oE(n,e){let t=vt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wf(t)}var aE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function E_(n){return n.replace(aE,lE)}function lE(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function w_(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var cE={[oo]:"SHADOWMAP_TYPE_PCF",[vs]:"SHADOWMAP_TYPE_VSM"};function uE(n){return cE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var hE={[qr]:"ENVMAP_MODE_REFRACTION"};function fE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":hE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var pE={[ao]:"ENVMAP_BLENDING_MULTIPLY",[hm]:"ENVMAP_BLENDING_MIX",[fm]:"ENVMAP_BLENDING_ADD"};function dE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":pE[n.combine]||"ENVMAP_BLENDING_NONE"}function T_(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=uE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=fE(t),h=dE(t),f=iE(t),p=nE(s),m=r.createProgram(),M,d,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Tl).join(`
`),M.length>0&&(M+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Tl).join(`
`),d.length>0&&(d+=`
`)):(M=[w_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),d=[w_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==pn?"#define TONE_MAPPING":"",t.toneMapping!==pn?vt.tonemapping_pars_fragment:"",t.toneMapping!==pn?eE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",vt.colorspace_pars_fragment,Qb("linearToOutputTexel",t.outputColorSpace),tE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Tl).join(`
`)),o=wf(o),o=y_(o,t),o=b_(o,t),a=wf(a),a=y_(a,t),a=b_(a,t),o=E_(o),a=E_(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,M=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,d=["#define varying in",t.glslVersion===zh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===zh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=g+M+o,T=g+d+a,S=Ef(r,r.VERTEX_SHADER,v),C=Ef(r,r.FRAGMENT_SHADER,T);r.attachShader(m,S),r.attachShader(m,C),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function A(D){if(n.debug.checkShaderErrors){let L=r.getProgramInfoLog(m)||"",G=r.getShaderInfoLog(S)||"",W=r.getShaderInfoLog(C)||"",I=L.trim(),H=G.trim(),q=W.trim(),z=!0,ce=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,S,C);else{let $=S_(r,S,"vertex"),Q=S_(r,C,"fragment");bt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+I+`
`+$+`
`+Q)}else I!==""?Xe("WebGLProgram: Program Info Log:",I):(H===""||q==="")&&(ce=!1);ce&&(D.diagnostics={runnable:z,programLog:I,vertexShader:{log:H,prefix:M},fragmentShader:{log:q,prefix:d}})}r.deleteShader(S),r.deleteShader(C),x=new os(r,m),E=rE(r,m)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=r.getProgramParameter(m,Kb)),B},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=$b++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=C,this}var mE=0,Iu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Tf(e),t.set(e,i)),i}},Tf=class{constructor(e){this.id=mE++,this.code=e,this.usedTimes=0}};function gE(n){return n===gn||n===Ms||n===Ss}function A_(n,e,t,i,r,s){let o=new To,a=new Iu,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,E,B,D,L,G){let W=D.fog,I=L.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||H,q),ce=f[x.type],$=i.precision;x.precision!==null&&($=i.getMaxPrecision(x.precision),$!==x.precision&&Xe("WebGLProgram.getParameters:",x.precision,"not supported, using",$,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ee=Q!==void 0?Q.length:0,pe=0;I.morphAttributes.position!==void 0&&(pe=1),I.morphAttributes.normal!==void 0&&(pe=2),I.morphAttributes.color!==void 0&&(pe=3);let ue,j,xe,ve;if(ce){let Ue=Nn[ce];ue=Ue.vertexShader,j=Ue.fragmentShader}else{ue=x.vertexShader,j=x.fragmentShader;let Ue=a.getVertexShaderStage(x),Mt=a.getFragmentShaderStage(x);a.update(x,Ue,Mt),xe=Ue.id,ve=Mt.id}let De=n.getRenderTarget(),Ee=n.state.buffers.depth.getReversed(),He=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,Je=!!x.map,at=!!x.matcap,rt=!!z,se=rt&&z.isPMREMTexture===!0,Me=!!x.aoMap,_e=!!x.lightMap,Be=!!x.bumpMap&&x.wireframe===!1,Ie=!!x.normalMap,nt=!!x.displacementMap,ke=!!x.emissiveMap,gt=!!x.metalnessMap,pt=!!x.roughnessMap,St=x.anisotropy>0,F=x.clearcoat>0,ye=x.diffuseRoughness>0,qe=x.dispersion>0,ht=x.retroreflectivity>0,we=x.iridescence>0,Nt=x.sheen>0,$e=x.transmission>0,it=St&&!!x.anisotropyMap,R=F&&!!x.clearcoatMap,y=F&&!!x.clearcoatNormalMap,X=F&&!!x.clearcoatRoughnessMap,fe=ye&&!!x.diffuseRoughnessMap,oe=we&&!!x.iridescenceMap,be=we&&!!x.iridescenceThicknessMap,Te=Nt&&!!x.sheenColorMap,te=Nt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,ge=!!x.specularColorMap,N=!!x.specularIntensityMap,re=$e&&!!x.transmissionMap,ie=$e&&!!x.thicknessMap,Ce=!!x.gradientMap,Se=!!x.alphaMap,Re=x.alphaTest>0,Qe=!!x.alphaHash,ct=!!x.extensions,he=pn;x.toneMapped&&(De===null||De.isXRRenderTarget===!0)&&(he=n.toneMapping);let Ye=se?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ut={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:j,defines:x.defines,customVertexShaderID:xe,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:$,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:He,instancingColor:He&&L.instanceColor!==null,instancingMorph:He&&L.morphTexture!==null,outputColorSpace:De===null?n.outputColorSpace:De.isXRRenderTarget===!0?De.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Je,matcap:at,envMap:rt,envMapMode:rt&&z.mapping,envMapPMREM:se,envMapMaxLod:se?Ye.length-1:null,envMapSize:se?Ye[0].width:null,aoMap:Me,lightMap:_e,bumpMap:Be,normalMap:Ie,displacementMap:nt,emissiveMap:ke,normalMapObjectSpace:Ie&&x.normalMapType===mm,normalMapTangentSpace:Ie&&x.normalMapType===al,packedNormalMap:Ie&&x.normalMapType===al&&gE(x.normalMap.format),metalnessMap:gt,roughnessMap:pt,anisotropy:St,anisotropyMap:it,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:y,clearcoatRoughnessMap:X,diffuseRoughness:ye,diffuseRoughnessMap:fe,dispersion:qe,retroreflection:ht,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:be,sheen:Nt,sheenColorMap:Te,sheenRoughnessMap:te,specularMap:ne,specularColorMap:ge,specularIntensityMap:N,transmission:$e,transmissionMap:re,thicknessMap:ie,gradientMap:Ce,opaque:x.transparent===!1&&x.blending===Vr&&x.alphaToCoverage===!1,alphaMap:Se,alphaTest:Re,alphaHash:Qe,combine:x.combine,mapUv:Je&&p(x.map.channel),aoMapUv:Me&&p(x.aoMap.channel),lightMapUv:_e&&p(x.lightMap.channel),bumpMapUv:Be&&p(x.bumpMap.channel),normalMapUv:Ie&&p(x.normalMap.channel),displacementMapUv:nt&&p(x.displacementMap.channel),emissiveMapUv:ke&&p(x.emissiveMap.channel),metalnessMapUv:gt&&p(x.metalnessMap.channel),roughnessMapUv:pt&&p(x.roughnessMap.channel),anisotropyMapUv:it&&p(x.anisotropyMap.channel),clearcoatMapUv:R&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:y&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:be&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:Te&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(x.sheenRoughnessMap.channel),specularMapUv:ne&&p(x.specularMap.channel),specularColorMapUv:ge&&p(x.specularColorMap.channel),specularIntensityMapUv:N&&p(x.specularIntensityMap.channel),transmissionMapUv:re&&p(x.transmissionMap.channel),thicknessMapUv:ie&&p(x.thicknessMap.channel),alphaMapUv:Se&&p(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ie||St),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Je||Se),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Ie===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Ee,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:pe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Ue=>Ue.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:he,decodeVideoTexture:Je&&x.map.isVideoTexture===!0&&_t.getTransfer(x.map.colorSpace)===Pt,decodeVideoTextureEmissive:ke&&x.emissiveMap.isVideoTexture===!0&&_t.getTransfer(x.emissiveMap.colorSpace)===Pt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===yi,flipSided:x.side===ei,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ct&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ct&&x.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ut.vertexUv1s=l.has(1),ut.vertexUv2s=l.has(2),ut.vertexUv3s=l.has(3),l.clear(),ut}function M(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)E.push(B),E.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(d(E,x),g(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function d(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function g(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let E=f[x.type],B;if(E){let D=Nn[E];B=cg.clone(D.uniforms)}else B=x.uniforms;return B}function T(x,E){let B=u.get(E);return B!==void 0?++B.usedTimes:(B=new T_(n,E,x,r),c.push(B),u.set(E,B)),B}function S(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:M,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function R_(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function xE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function C_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function P_(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,m,M,d,g){let v=n[e];return v===void 0?(v={id:f.id,object:f,geometry:p,material:m,materialVariant:o(f),groupOrder:M,renderOrder:f.renderOrder,z:d,group:g},n[e]=v):(v.id=f.id,v.object=f,v.geometry=p,v.material=m,v.materialVariant=o(f),v.groupOrder=M,v.renderOrder=f.renderOrder,v.z=d,v.group=g),e++,v}function l(f,p,m,M,d,g,v){v.reversedDepth===!0&&(d=-d);let T=a(f,p,m,M,d,g);m.transmission>0?i.push(T):m.transparent===!0?r.push(T):t.push(T)}function c(f,p,m,M,d,g){let v=a(f,p,m,M,d,g);m.transmission>0?i.unshift(v):m.transparent===!0?r.unshift(v):t.unshift(v)}function u(f,p){t.length>1&&t.sort(f||xE),i.length>1&&i.sort(p||C_),r.length>1&&r.sort(p||C_)}function h(){for(let f=e,p=n.length;f<p;f++){let m=n[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function L_(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new P_,n.set(i,[o])):r>=s.length?(o=new P_,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function _E(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new O,color:new tt};break;case"SpotLight":t={position:new O,direction:new O,color:new tt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new O,color:new tt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new O,skyColor:new tt,groundColor:new tt};break;case"RectAreaLight":t={color:new tt,position:new O,halfWidth:new O,halfHeight:new O};break}return n[e.id]=t,t}}}function vE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new le,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var ME=0;function SE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function D_(n){let e=new _E,t=vE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new O);let r=new O,s=new st,o=new st;function a(c){let u=0,h=0,f=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let p=0,m=0,M=0,d=0,g=0,v=0,T=0,S=0,C=0,A=0,x=0,E=0,B=0,D=0;c.sort(SE);for(let G=0,W=c.length;G<W;G++){let I=c[G],H=I.color,q=I.intensity,z=I.distance,ce=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===gn?ce=I.shadow.map.texture:ce=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=H.r*q,h+=H.g*q,f+=H.b*q;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],q);D++}else if(I.isSunLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=ee,i.sunShadowMap[m]=ce;let pe=Q.getViewportCount();for(let ue=0;ue<pe;ue++)i.sunShadowMatrix[M+ue]=Q.getMatrix(ue),i.sunShadowCascade[M+ue]=Q._cascadeData[ue];M+=pe,m++}i.sun[p]=$,p++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,i.directionalShadow[d]=ee,i.directionalShadowMap[d]=ce,i.directionalShadowMatrix[d]=I.shadow.matrix,C++}i.directional[d]=$,d++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(H).multiplyScalar(q),$.distance=z,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[v]=$;let Q=I.shadow;if(I.map&&(i.spotLightMap[E]=I.map,E++,Q.updateMatrices(I),I.castShadow&&B++),i.spotLightMatrix[v]=Q.matrix,I.castShadow){let ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,i.spotShadow[v]=ee,i.spotShadowMap[v]=ce,x++}v++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(H).multiplyScalar(q),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[T]=$,T++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let Q=I.shadow,ee=t.get(I);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,ee.shadowCameraNear=Q.camera.near,ee.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ee,i.pointShadowMap[g]=ce,i.pointShadowMatrix[g]=I.shadow.matrix,A++}i.point[g]=$,g++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(q),$.groundColor.copy(I.groundColor).multiplyScalar(q),i.hemi[S]=$,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let L=i.hash;(L.sunLength!==p||L.directionalLength!==d||L.pointLength!==g||L.spotLength!==v||L.rectAreaLength!==T||L.hemiLength!==S||L.numSunShadows!==m||L.numDirectionalShadows!==C||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==D)&&(i.sun.length=p,i.directional.length=d,i.spot.length=v,i.rectArea.length=T,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-B,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=D,L.sunLength=p,L.directionalLength=d,L.pointLength=g,L.spotLength=v,L.rectAreaLength=T,L.hemiLength=S,L.numSunShadows=m,L.numDirectionalShadows=C,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=D,i.version=ME++)}function l(c,u){let h=0,f=0,p=0,m=0,M=0,d=0,g=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),h++}else if(S.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(g),f++}else if(S.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let C=i.rectArea[M];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),o.identity(),s.copy(S.matrixWorld),s.premultiply(g),o.extractRotation(s),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),M++}else if(S.isPointLight){let C=i.point[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),p++}else if(S.isHemisphereLight){let C=i.hemi[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),d++}}}return{setup:a,setupView:l,state:i}}function I_(n){let e=new D_(n),t=[],i=[],r=[];function s(h){u.camera=h,t.length=0,i.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function U_(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new I_(n),e.set(r,[a])):s>=o.length?(a=new I_(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var F_=`
void main() {
gl_Position = vec4( position, 1.0 );
}
`,N_=`
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
`;var bE=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],EE=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],O_=new st,Al=new O,Af=new O;function B_(n,e,t){let i=new Qn,r=new le,s=new le,o=new It,a=new Su,l=new yu,c={},u=t.maxTextureSize,h={[An]:ei,[ei]:An,[yi]:yi},f=new hi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new le},radius:{value:4}},vertexShader:F_,fragmentShader:N_}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new zt;m.setAttribute("position",new _n(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new At(m,f),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=oo;let g=this.type;this.render=function(A,x,E){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===qd&&(Xe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=oo);let B=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),G=n.state;G.setBlending(cr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=g!==this.type;W&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(H=>H.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,H=A.length;I<H;I++){let q=A[I],z=q.shadow;if(z===void 0){Xe("WebGLShadowMap:",q,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let ce=z.getFrameExtents();r.multiply(ce),s.copy(z.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/ce.x),r.x=s.x*ce.x,z.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/ce.y),r.y=s.y*ce.y,z.mapSize.y=s.y));let $=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=$,z.map===null||W===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===vs){if(q.isPointLight){Xe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Gi(r.x,r.y,{format:gn,type:Di,minFilter:xi,magFilter:xi,generateMipmaps:!1}),z.map.texture.name=q.name+".shadowMap",z.map.depthTexture=new Sn(r.x,r.y,bi),z.map.depthTexture.name=q.name+".shadowMapDepth",z.map.depthTexture.format=tn,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Jt,z.map.depthTexture.magFilter=Jt}else q.isPointLight?(z.map=new ss(r.x),z.map.depthTexture=new zo(r.x,Li)):(z.map=new Gi(r.x,r.y),z.map.depthTexture=new Sn(r.x,r.y,Li)),z.map.depthTexture.name=q.name+".shadowMap",z.map.depthTexture.format=tn,this.type===oo?(z.map.depthTexture.compareFunction=$?Uc:Ic,z.map.depthTexture.minFilter=xi,z.map.depthTexture.magFilter=xi):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Jt,z.map.depthTexture.magFilter=Jt);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==r.x||z.map.height!==r.y)&&z.map.setSize(r.x,r.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();q.isPointLight!==!0&&z.updateMatrices(q,E);let ee=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:E.layers;for(let pe=0;pe<Q;pe++){let ue=z.getCamera(pe);if(q.isPointLight){let j=z.camera,xe=z.matrix,ve=q.distance||j.far;ve!==j.far&&(j.far=ve,j.updateProjectionMatrix()),Al.setFromMatrixPosition(q.matrixWorld),j.position.copy(Al),Af.copy(j.position),Af.add(bE[pe]),j.up.copy(EE[pe]),j.lookAt(Af),j.updateMatrixWorld(),xe.makeTranslation(-Al.x,-Al.y,-Al.z),O_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),z._frustum.setFromProjectionMatrix(O_,j.coordinateSystem,j.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(z.map),n.clear());let j=z.getViewport(pe);o.set(s.x*j.x,s.y*j.y,s.x*j.z,s.y*j.w),G.viewport(o)}i=z.getFrustum(pe),S(x,E,ue,q,ee,this.type)}z.isPointLightShadow!==!0&&this.type===vs&&v(z,E),z.needsUpdate=!1}g=this.type,d.needsUpdate=!1,n.setRenderTarget(B,D,L)};function v(A,x){let E=e.update(M);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new Gi(r.x,r.y,{format:gn,type:Di}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,E,f,M,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,E,p,M,null)}function T(A,x,E,B){let D=null,L=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=D.uuid,W=x.uuid,I=c[G];I===void 0&&(I={},c[G]=I);let H=I[W];H===void 0&&(H=D.clone(),I[W]=H,x.addEventListener("dispose",C)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,B===vs?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:h[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let G=n.properties.get(D);G.light=E}return D}function S(A,x,E,B,D,L){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===vs)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let I=e.update(A),H=A.material;if(Array.isArray(H)){let q=I.groups;for(let z=0,ce=q.length;z<ce;z++){let $=q[z],Q=H[$.materialIndex];if(Q&&Q.visible){let ee=T(A,Q,B,L);A.onBeforeShadow(n,A,x,E,I,ee,$),n.renderBufferDirect(E,null,I,ee,A,$),A.onAfterShadow(n,A,x,E,I,ee,$)}}}else if(H.visible){let q=T(A,H,B,L);A.onBeforeShadow(n,A,x,E,I,q,null),n.renderBufferDirect(E,null,I,q,A,null),A.onAfterShadow(n,A,x,E,I,q,null)}}let W=A.children;for(let I=0,H=W.length;I<H;I++)S(W[I],x,E,B,D,L)}function C(A){A.target.removeEventListener("dispose",C);for(let E in c){let B=c[E],D=A.target.uuid;D in B&&(B[D].dispose(),delete B[D])}}}function k_(n,e){function t(){let N=!1,re=new It,ie=null,Ce=new It(0,0,0,0);return{setMask:function(Se){ie!==Se&&!N&&(n.colorMask(Se,Se,Se,Se),ie=Se)},setLocked:function(Se){N=Se},setClear:function(Se,Re,Qe,ct,he){he===!0&&(Se*=ct,Re*=ct,Qe*=ct),re.set(Se,Re,Qe,ct),Ce.equals(re)===!1&&(n.clearColor(Se,Re,Qe,ct),Ce.copy(re))},reset:function(){N=!1,ie=null,Ce.set(-1,0,0,0)}}}function i(){let N=!1,re=!1,ie=null,Ce=null,Se=null;return{setReversed:function(Re){if(re!==Re){let Qe=e.get("EXT_clip_control");Re?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT),re=Re;let ct=Se;Se=null,this.setClear(ct)}},getReversed:function(){return re},setTest:function(Re){Re?Ee(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Re){ie!==Re&&!N&&(n.depthMask(Re),ie=Re)},setFunc:function(Re){if(re&&(Re=Cm[Re]),Ce!==Re){switch(Re){case ya:n.depthFunc(n.NEVER);break;case ba:n.depthFunc(n.ALWAYS);break;case Ea:n.depthFunc(n.LESS);break;case Xr:n.depthFunc(n.LEQUAL);break;case wa:n.depthFunc(n.EQUAL);break;case Ta:n.depthFunc(n.GEQUAL);break;case Aa:n.depthFunc(n.GREATER);break;case Ra:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ce=Re}},setLocked:function(Re){N=Re},setClear:function(Re){Se!==Re&&(Se=Re,re&&(Re=1-Re),n.clearDepth(Re))},reset:function(){N=!1,ie=null,Ce=null,Se=null,re=!1}}}function r(){let N=!1,re=null,ie=null,Ce=null,Se=null,Re=null,Qe=null,ct=null,he=null;return{setTest:function(Ye){N||(Ye?Ee(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Ye){re!==Ye&&!N&&(n.stencilMask(Ye),re=Ye)},setFunc:function(Ye,ut,Ue){(ie!==Ye||Ce!==ut||Se!==Ue)&&(n.stencilFunc(Ye,ut,Ue),ie=Ye,Ce=ut,Se=Ue)},setOp:function(Ye,ut,Ue){(Re!==Ye||Qe!==ut||ct!==Ue)&&(n.stencilOp(Ye,ut,Ue),Re=Ye,Qe=ut,ct=Ue)},setLocked:function(Ye){N=Ye},setClear:function(Ye){he!==Ye&&(n.clearStencil(Ye),he=Ye)},reset:function(){N=!1,re=null,ie=null,Ce=null,Se=null,Re=null,Qe=null,ct=null,he=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,u={},h={},f={},p=new WeakMap,m=[],M=null,d=!1,g=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new tt(0,0,0),B=0,D=!1,L=null,G=null,W=null,I=null,H=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ce=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec($)[1]),z=ce>=1):$.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),z=ce>=2);let Q=null,ee={},pe=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),j=new It().fromArray(pe),xe=new It().fromArray(ue);function ve(N,re,ie,Ce){let Se=new Uint8Array(4),Re=n.createTexture();n.bindTexture(N,Re),n.texParameteri(N,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(N,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Qe=0;Qe<ie;Qe++)N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ce,0,n.RGBA,n.UNSIGNED_BYTE,Se):n.texImage2D(re+Qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Se);return Re}let De={};De[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),De[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),De[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),De[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ee(n.DEPTH_TEST),o.setFunc(Xr),Be(!1),Ie(Nh),Ee(n.CULL_FACE),Me(cr);function Ee(N){u[N]!==!0&&(n.enable(N),u[N]=!0)}function He(N){u[N]!==!1&&(n.disable(N),u[N]=!1)}function ot(N,re){return f[N]!==re?(n.bindFramebuffer(N,re),f[N]=re,N===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=re),N===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Je(N,re){let ie=m,Ce=!1;if(N){ie=p.get(re),ie===void 0&&(ie=[],p.set(re,ie));let Se=N.textures;if(ie.length!==Se.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Re=0,Qe=Se.length;Re<Qe;Re++)ie[Re]=n.COLOR_ATTACHMENT0+Re;ie.length=Se.length,Ce=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ce=!0);Ce&&n.drawBuffers(ie)}function at(N){return M!==N?(n.useProgram(N),M=N,!0):!1}let rt={[Wr]:n.FUNC_ADD,[Kd]:n.FUNC_SUBTRACT,[$d]:n.FUNC_REVERSE_SUBTRACT};rt[Zd]=n.MIN,rt[Jd]=n.MAX;let se={[Qd]:n.ZERO,[jd]:n.ONE,[em]:n.SRC_COLOR,[mc]:n.SRC_ALPHA,[om]:n.SRC_ALPHA_SATURATE,[rm]:n.DST_COLOR,[im]:n.DST_ALPHA,[tm]:n.ONE_MINUS_SRC_COLOR,[gc]:n.ONE_MINUS_SRC_ALPHA,[sm]:n.ONE_MINUS_DST_COLOR,[nm]:n.ONE_MINUS_DST_ALPHA,[am]:n.CONSTANT_COLOR,[lm]:n.ONE_MINUS_CONSTANT_COLOR,[cm]:n.CONSTANT_ALPHA,[um]:n.ONE_MINUS_CONSTANT_ALPHA};function Me(N,re,ie,Ce,Se,Re,Qe,ct,he,Ye){if(N===cr){d===!0&&(He(n.BLEND),d=!1);return}if(d===!1&&(Ee(n.BLEND),d=!0),N!==Yd){if(N!==g||Ye!==D){if((v!==Wr||C!==Wr)&&(n.blendEquation(n.FUNC_ADD),v=Wr,C=Wr),Ye)switch(N){case Vr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Oh:n.blendFunc(n.ONE,n.ONE);break;case Bh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case kh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:bt("WebGLState: Invalid blending: ",N);break}else switch(N){case Vr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Oh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Bh:bt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case kh:bt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:bt("WebGLState: Invalid blending: ",N);break}T=null,S=null,A=null,x=null,E.set(0,0,0),B=0,g=N,D=Ye}return}Se=Se||re,Re=Re||ie,Qe=Qe||Ce,(re!==v||Se!==C)&&(n.blendEquationSeparate(rt[re],rt[Se]),v=re,C=Se),(ie!==T||Ce!==S||Re!==A||Qe!==x)&&(n.blendFuncSeparate(se[ie],se[Ce],se[Re],se[Qe]),T=ie,S=Ce,A=Re,x=Qe),(ct.equals(E)===!1||he!==B)&&(n.blendColor(ct.r,ct.g,ct.b,he),E.copy(ct),B=he),g=N,D=!1}function _e(N,re){N.side===yi?He(n.CULL_FACE):Ee(n.CULL_FACE);let ie=N.side===ei;re&&(ie=!ie),Be(ie),N.blending===Vr&&N.transparent===!1?Me(cr):Me(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),s.setMask(N.colorWrite);let Ce=N.stencilWrite;a.setTest(Ce),Ce&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),ke(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?Ee(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function Be(N){L!==N&&(N?n.frontFace(n.CW):n.frontFace(n.CCW),L=N)}function Ie(N){N!==Wd?(Ee(n.CULL_FACE),N!==G&&(N===Nh?n.cullFace(n.BACK):N===Xd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),G=N}function nt(N){N!==W&&(z&&n.lineWidth(N),W=N)}function ke(N,re,ie){N?(Ee(n.POLYGON_OFFSET_FILL),(I!==re||H!==ie)&&(I=re,H=ie,o.getReversed()&&(re=-re,ie=-ie),n.polygonOffset(re,ie))):He(n.POLYGON_OFFSET_FILL)}function gt(N){N?Ee(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function pt(N){N===void 0&&(N=n.TEXTURE0+q-1),Q!==N&&(n.activeTexture(N),Q=N)}function St(N,re,ie){ie===void 0&&(Q===null?ie=n.TEXTURE0+q-1:ie=Q);let Ce=ee[ie];Ce===void 0&&(Ce={type:void 0,texture:void 0},ee[ie]=Ce),(Ce.type!==N||Ce.texture!==re)&&(Q!==ie&&(n.activeTexture(ie),Q=ie),n.bindTexture(N,re||De[N]),Ce.type=N,Ce.texture=re)}function F(){let N=ee[Q];N!==void 0&&N.type!==void 0&&(n.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function ye(){try{n.compressedTexImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function ht(){try{n.texSubImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function we(){try{n.texSubImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function Nt(){try{n.compressedTexSubImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function $e(){try{n.compressedTexSubImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function it(){try{n.texStorage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function R(){try{n.texStorage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function y(){try{n.texImage2D(...arguments)}catch(N){bt("WebGLState:",N)}}function X(){try{n.texImage3D(...arguments)}catch(N){bt("WebGLState:",N)}}function fe(N){return h[N]!==void 0?h[N]:n.getParameter(N)}function oe(N,re){h[N]!==re&&(n.pixelStorei(N,re),h[N]=re)}function be(N){j.equals(N)===!1&&(n.scissor(N.x,N.y,N.z,N.w),j.copy(N))}function Te(N){xe.equals(N)===!1&&(n.viewport(N.x,N.y,N.z,N.w),xe.copy(N))}function te(N,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Ce=ie.get(N);Ce===void 0&&(Ce=n.getUniformBlockIndex(re,N.name),n.uniformBlockBinding(re,Ce,Ce),ie.set(N,Ce))}function ne(N,re,ie){let Se=c.get(re).get(N);l[Se]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,Se,ie),l[Se]=ie)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ee={},f={},l={},p=new WeakMap,m=[],M=null,d=!1,g=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new tt(0,0,0),B=0,D=!1,L=null,G=null,W=null,I=null,H=null,j.set(0,0,n.canvas.width,n.canvas.height),xe.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:Ee,disable:He,bindFramebuffer:ot,drawBuffers:Je,useProgram:at,setBlending:Me,setMaterial:_e,setFlipSided:Be,setCullFace:Ie,setLineWidth:nt,setPolygonOffset:ke,setScissorTest:gt,activeTexture:pt,bindTexture:St,unbindTexture:F,compressedTexImage2D:ye,compressedTexImage3D:qe,texImage2D:y,texImage3D:X,pixelStorei:oe,getParameter:fe,updateUBOMapping:te,uniformBlockBinding:ne,texStorage2D:it,texStorage3D:R,texSubImage2D:ht,texSubImage3D:we,compressedTexSubImage2D:Nt,compressedTexSubImage3D:$e,scissor:be,viewport:Te,reset:ge}}function G_(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new le,u=new WeakMap,h=new Set,f,p=new WeakMap,m=new Set,M=new FinalizationRegistry(R=>m.delete(R)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,y){return d?new OffscreenCanvas(R,y):yo("canvas")}function v(R,y,X){let fe=1,oe=it(R);if((oe.width>X||oe.height>X)&&(fe=X/Math.max(oe.width,oe.height)),fe<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let be=Math.floor(fe*oe.width),Te=Math.floor(fe*oe.height);f===void 0&&(f=g(be,Te));let te=y?g(be,Te):f;return te.width=be,te.height=Te,te.getContext("2d").drawImage(R,0,0,be,Te),Xe("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+be+"x"+Te+")."),te}else return"data"in R&&Xe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,y,X,fe,oe,be=!1){if(R!==null){if(n[R]!==void 0)return n[R];Xe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Te;fe&&(Te=e.get("EXT_texture_norm16"),Te||Xe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=y;if(y===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.R16_EXT),X===n.SHORT&&Te&&(te=Te.R16_SNORM_EXT)),y===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),y===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.RG16_EXT),X===n.SHORT&&Te&&(te=Te.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),y===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),y===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),y===n.RGB&&(X===n.UNSIGNED_SHORT&&Te&&(te=Te.RGB16_EXT),X===n.SHORT&&Te&&(te=Te.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),y===n.RGBA){let ne=be?bs:_t.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ne===Pt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&Te&&(te=Te.RGBA16_EXT),X===n.SHORT&&Te&&(te=Te.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,y){let X;return R?y===null||y===Li||y===Xn?X=n.DEPTH24_STENCIL8:y===bi?X=n.DEPTH32F_STENCIL8:y===br&&(X=n.DEPTH24_STENCIL8,Xe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Li||y===Xn?X=n.DEPTH_COMPONENT24:y===bi?X=n.DEPTH_COMPONENT32F:y===br&&(X=n.DEPTH_COMPONENT16),X}function E(R,y){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==Jt&&R.minFilter!==xi?Math.log2(Math.max(y.width,y.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?y.mipmaps.length:1}function B(R){let y=new WeakRef(R);i.get(R).__ref=y,m.add(y),M.register(R,y,y)}function D(R){let y=i.get(R).__ref;y!==void 0&&(m.delete(y),M.unregister(y))}function L(R){W(R.target)}function G(R){I(R.target)}function W(R){R.removeEventListener("dispose",L),D(R),q(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function I(R){R.removeEventListener("dispose",G),D(R),ce(R)}function H(){for(let R of m){let y=R.deref();y!==void 0&&(y.isRenderTarget===!0?I(y):W(y))}m.clear(),h.clear()}function q(R){let y=i.get(R);if(y.__webglInit===void 0)return;let X=R.source,fe=p.get(X);if(fe){let oe=fe[y.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&z(R),Object.keys(fe).length===0&&p.delete(X)}i.remove(R)}function z(R){let y=i.get(R);n.deleteTexture(y.__webglTexture);let X=R.source,fe=p.get(X);delete fe[y.__cacheKey],o.memory.textures--}function ce(R){let y=i.get(R);y.__depthDisposeCallback&&y.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&W(X),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(y.__webglFramebuffer[oe]))for(let be=0;be<y.__webglFramebuffer[oe].length;be++)n.deleteFramebuffer(y.__webglFramebuffer[oe][be]);else n.deleteFramebuffer(y.__webglFramebuffer[oe]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[oe])}else{if(Array.isArray(y.__webglFramebuffer))for(let oe=0;oe<y.__webglFramebuffer.length;oe++)n.deleteFramebuffer(y.__webglFramebuffer[oe]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let oe=0;oe<y.__webglColorRenderbuffer.length;oe++)y.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[oe]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let fe=R.textures;for(let oe=0,be=fe.length;oe<be;oe++){let Te=i.get(fe[oe]);Te.__webglTexture&&(n.deleteTexture(Te.__webglTexture),o.memory.textures--),i.remove(fe[oe])}i.remove(R)}let $=0;function Q(){$=0}function ee(){return $}function pe(R){$=R}function ue(){let R=$;return R>=r.maxTextures&&Xe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,R}function j(R){let y=[];return y.push(R.wrapS),y.push(R.wrapT),y.push(R.wrapR||0),y.push(R.magFilter),y.push(R.minFilter),y.push(R.anisotropy),y.push(R.internalFormat),y.push(R.format),y.push(R.type),y.push(R.generateMipmaps),y.push(R.mipmapsAutoUpdate),y.push(R.premultiplyAlpha),y.push(R.flipY),y.push(R.unpackAlignment),y.push(R.colorSpace),y.join()}function xe(R,y){let X=i.get(R);if(R.isVideoTexture&&Nt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let fe=R.image;if(fe===null)Xe("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)Xe("WebGLRenderer: Texture marked for update but image is incomplete");else{_e(X,R,y);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+y)}function ve(R,y){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){_e(X,R,y);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+y)}function De(R,y){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){_e(X,R,y);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+y)}function Ee(R,y){let X=i.get(R);if(R.version>0&&X.__version!==R.version){Be(X,R,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+y)}let He={[Yr]:n.REPEAT,[en]:n.CLAMP_TO_EDGE,[Ca]:n.MIRRORED_REPEAT},ot={[Jt]:n.NEAREST,[pm]:n.NEAREST_MIPMAP_NEAREST,[Pa]:n.NEAREST_MIPMAP_LINEAR,[xi]:n.LINEAR,[wc]:n.LINEAR_MIPMAP_NEAREST,[dn]:n.LINEAR_MIPMAP_LINEAR},Je={[xm]:n.NEVER,[Fc]:n.ALWAYS,[_m]:n.LESS,[Ic]:n.LEQUAL,[vm]:n.EQUAL,[Uc]:n.GEQUAL,[Mm]:n.GREATER,[Sm]:n.NOTEQUAL};function at(R,y){if(y.type===bi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===xi||y.magFilter===wc||y.magFilter===Pa||y.magFilter===dn||y.minFilter===xi||y.minFilter===wc||y.minFilter===Pa||y.minFilter===dn)&&Xe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,He[y.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,He[y.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,He[y.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[y.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[y.minFilter]),y.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Je[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Jt||y.minFilter!==Pa&&y.minFilter!==dn||y.type===bi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,r.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function rt(R,y){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,y.addEventListener("dispose",L),B(y));let fe=y.source,oe=p.get(fe);oe===void 0&&(oe={},p.set(fe,oe));let be=j(y);if(be!==R.__cacheKey){oe[be]===void 0&&(oe[be]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[be].usedTimes++;let Te=oe[R.__cacheKey];Te!==void 0&&(oe[R.__cacheKey].usedTimes--,Te.usedTimes===0&&z(y)),R.__cacheKey=be,R.__webglTexture=oe[be].texture}return X}function se(R,y,X){return Math.floor(Math.floor(R/X)/y)}function Me(R,y,X,fe){let be=R.updateRanges;if(be.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,X,fe,y.data);else{be.sort((N,re)=>N.start-re.start);let Te=0;for(let N=1;N<be.length;N++){let re=be[Te],ie=be[N],Ce=re.start+re.count,Se=se(ie.start,y.width,4),Re=se(re.start,y.width,4);ie.start<=Ce+1&&Se===Re&&se(ie.start+ie.count-1,y.width,4)===Se?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++Te,be[Te]=ie)}be.length=Te+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ne=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let N=0,re=be.length;N<re;N++){let ie=be[N],Ce=Math.floor(ie.start/4),Se=Math.ceil(ie.count/4),Re=Ce%y.width,Qe=Math.floor(Ce/y.width),ct=Se,he=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Re),t.pixelStorei(n.UNPACK_SKIP_ROWS,Qe),t.texSubImage2D(n.TEXTURE_2D,0,Re,Qe,ct,he,X,fe,y.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function _e(R,y,X){let fe=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(fe=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(fe=n.TEXTURE_3D);let oe=rt(R,y),be=y.source;t.bindTexture(fe,R.__webglTexture,n.TEXTURE0+X);let Te=i.get(be);if(be.version!==Te.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let he=_t.getPrimaries(_t.workingColorSpace),Ye=y.colorSpace===Rn?null:_t.getPrimaries(y.colorSpace),ut=y.colorSpace===Rn||he===Ye?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ut)}t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=v(y.image,!1,r.maxTextureSize);ne=$e(y,ne);let ge=s.convert(y.format,y.colorSpace),N=s.convert(y.type),re=A(y.internalFormat,ge,N,y.normalized,y.colorSpace,y.isVideoTexture);at(fe,y);let ie,Ce=y.mipmaps,Se=y.isVideoTexture!==!0,Re=Te.__version===void 0||oe===!0,Qe=be.dataReady,ct=E(y,ne);if(y.isDepthTexture)re=x(y.format===mn,y.type),Re&&(Se?t.texStorage2D(n.TEXTURE_2D,1,re,ne.width,ne.height):t.texImage2D(n.TEXTURE_2D,0,re,ne.width,ne.height,0,ge,N,null));else if(y.isDataTexture)if(Ce.length>0){Se&&Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,Ce[0].width,Ce[0].height);for(let he=0,Ye=Ce.length;he<Ye;he++)ie=Ce[he],Se?Qe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,N,ie.data):t.texImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ge,N,ie.data);y.generateMipmaps=!1}else Se?(Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,ne.width,ne.height),Qe&&Me(y,ne,ge,N)):t.texImage2D(n.TEXTURE_2D,0,re,ne.width,ne.height,0,ge,N,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Se&&Re&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ct,re,Ce[0].width,Ce[0].height,ne.depth);for(let he=0,Ye=Ce.length;he<Ye;he++)if(ie=Ce[he],y.format!==Hi)if(ge!==null)if(Se){if(Qe)if(y.layerUpdates.size>0){let ut=_f(ie.width,ie.height,y.format,y.type);for(let Ue of y.layerUpdates){let Mt=ie.data.subarray(Ue*ut/ie.data.BYTES_PER_ELEMENT,(Ue+1)*ut/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,Ue,ie.width,ie.height,1,ge,Mt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,ne.depth,ge,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,ne.depth,0,ie.data,0,0);else Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Se?Qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,ne.depth,ge,N,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,ne.depth,0,ge,N,ie.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{Se&&Re&&t.texStorage2D(n.TEXTURE_2D,ct,re,Ce[0].width,Ce[0].height);for(let he=0,Ye=Ce.length;he<Ye;he++)ie=Ce[he],y.format!==Hi?ge!==null?Se?Qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ie.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Se?Qe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,N,ie.data):t.texImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ge,N,ie.data)}else if(y.isDataArrayTexture)if(Se){if(Re&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ct,re,ne.width,ne.height,ne.depth),Qe)if(y.layerUpdates.size>0){let he=_f(ne.width,ne.height,y.format,y.type);for(let Ye of y.layerUpdates){let ut=ne.data.subarray(Ye*he/ne.data.BYTES_PER_ELEMENT,(Ye+1)*he/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ye,ne.width,ne.height,1,ge,N,ut)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,ge,N,ne.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ne.width,ne.height,ne.depth,0,ge,N,ne.data);else if(y.isData3DTexture)Se?(Re&&t.texStorage3D(n.TEXTURE_3D,ct,re,ne.width,ne.height,ne.depth),Qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,ge,N,ne.data)):t.texImage3D(n.TEXTURE_3D,0,re,ne.width,ne.height,ne.depth,0,ge,N,ne.data);else if(y.isFramebufferTexture){if(Re)if(Se)t.texStorage2D(n.TEXTURE_2D,ct,re,ne.width,ne.height);else{let he=ne.width,Ye=ne.height;for(let ut=0;ut<ct;ut++)t.texImage2D(n.TEXTURE_2D,ut,re,he,Ye,0,ge,N,null),he>>=1,Ye>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let he=n.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),ne.parentNode!==he){he.appendChild(ne),h.add(y),he.onpaint=Ye=>{let ut=Ye.changedElements;for(let Ue of h)ut.includes(Ue.image)&&(Ue.needsUpdate=!0)},he.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ne);else{let ut=n.RGBA,Ue=n.RGBA,Mt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ut,Ue,Mt,ne)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(Se&&Re){let he=it(Ce[0]);t.texStorage2D(n.TEXTURE_2D,ct,re,he.width,he.height)}for(let he=0,Ye=Ce.length;he<Ye;he++)ie=Ce[he],Se?Qe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ge,N,ie):t.texImage2D(n.TEXTURE_2D,he,re,ge,N,ie);y.generateMipmaps=!1}else if(Se){if(Re){let he=it(ne);t.texStorage2D(n.TEXTURE_2D,ct,re,he.width,he.height)}Qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,N,ne)}else t.texImage2D(n.TEXTURE_2D,0,re,ge,N,ne);T(y)&&y.mipmapsAutoUpdate===!0&&S(fe),Te.__version=be.version,y.onUpdate&&y.onUpdate(y)}R.__version=y.version}function Be(R,y,X){if(y.image.length!==6)return;let fe=rt(R,y),oe=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let be=i.get(oe);if(oe.version!==be.__version||fe===!0){t.activeTexture(n.TEXTURE0+X);let Te=_t.getPrimaries(_t.workingColorSpace),te=y.colorSpace===Rn?null:_t.getPrimaries(y.colorSpace),ne=y.colorSpace===Rn||Te===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let ge=y.isCompressedTexture||y.image[0].isCompressedTexture,N=y.image[0]&&y.image[0].isDataTexture,re=[];for(let Ue=0;Ue<6;Ue++)!ge&&!N?re[Ue]=v(y.image[Ue],!0,r.maxCubemapSize):re[Ue]=N?y.image[Ue].image:y.image[Ue],re[Ue]=$e(y,re[Ue]);let ie=re[0],Ce=s.convert(y.format,y.colorSpace),Se=s.convert(y.type),Re=A(y.internalFormat,Ce,Se,y.normalized,y.colorSpace),Qe=y.isVideoTexture!==!0,ct=be.__version===void 0||fe===!0,he=oe.dataReady,Ye=E(y,ie);at(n.TEXTURE_CUBE_MAP,y);let ut;if(y.isDepthTexture){if(Re=x(y.format===mn,y.type),ct)if(Qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Re,ie.width,ie.height);else for(let Ue=0;Ue<6;Ue++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,0,Re,ie.width,ie.height,0,Ce,Se,null)}else if(ge){Qe&&ct&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ye,Re,ie.width,ie.height);for(let Ue=0;Ue<6;Ue++){ut=re[Ue].mipmaps;for(let Mt=0;Mt<ut.length;Mt++){let Xt=ut[Mt];y.format!==Hi?Ce!==null?Qe?he&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt,0,0,Xt.width,Xt.height,Ce,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt,Re,Xt.width,Xt.height,0,Xt.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt,0,0,Xt.width,Xt.height,Ce,Se,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt,Re,Xt.width,Xt.height,0,Ce,Se,Xt.data)}}}else{if(ut=y.mipmaps,Qe&&ct){ut.length>0&&Ye++;let Ue=it(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ye,Re,Ue.width,Ue.height)}for(let Ue=0;Ue<6;Ue++)if(N){Qe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,0,0,0,re[Ue].width,re[Ue].height,Ce,Se,re[Ue].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,0,Re,re[Ue].width,re[Ue].height,0,Ce,Se,re[Ue].data);for(let Mt=0;Mt<ut.length;Mt++){let Yi=ut[Mt].image[Ue].image;Qe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt+1,0,0,Yi.width,Yi.height,Ce,Se,Yi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt+1,Re,Yi.width,Yi.height,0,Ce,Se,Yi.data)}}else{Qe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,0,0,0,Ce,Se,re[Ue]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,0,Re,Ce,Se,re[Ue]);for(let Mt=0;Mt<ut.length;Mt++){let Xt=ut[Mt];Qe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt+1,0,0,Ce,Se,Xt.image[Ue]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ue,Mt+1,Re,Ce,Se,Xt.image[Ue])}}}T(y)&&y.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),be.__version=oe.version,y.onUpdate&&y.onUpdate(y)}R.__version=y.version}function Ie(R,y,X,fe,oe,be){let Te=s.convert(X.format,X.colorSpace),te=s.convert(X.type),ne=A(X.internalFormat,Te,te,X.normalized,X.colorSpace),ge=i.get(y),N=i.get(X);if(N.__renderTarget=y,!ge.__hasExternalTextures){let re=Math.max(1,y.width>>be),ie=Math.max(1,y.height>>be);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,be,ne,re,ie,y.depth,0,Te,te,null):t.texImage2D(oe,be,ne,re,ie,0,Te,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,fe,oe,N.__webglTexture,0,ht(y)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,fe,oe,N.__webglTexture,be),t.bindFramebuffer(n.FRAMEBUFFER,null)}function nt(R,y,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),y.depthBuffer){let fe=y.depthTexture,oe=fe&&fe.isDepthTexture?fe.type:null,be=x(y.stencilBuffer,oe),Te=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(y),be,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(y),be,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,be,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Te,n.RENDERBUFFER,R)}else{let fe=y.textures;for(let oe=0;oe<fe.length;oe++){let be=fe[oe],Te=s.convert(be.format,be.colorSpace),te=s.convert(be.type),ne=A(be.internalFormat,Te,te,be.normalized,be.colorSpace);we(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(y),ne,y.width,y.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(y),ne,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,ne,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ke(R,y,X){let fe=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(y.depthTexture);oe.__renderTarget=y;let be=fe?y.depthTexture.image[0]:y.depthTexture.image;(!oe.__webglTexture||be.width!==y.width||be.height!==y.height)&&(be.width=y.width,be.height=y.height,y.depthTexture.needsUpdate=!0),fe?Ee(y.depthTexture,0):xe(y.depthTexture,0);let Te=oe.__webglTexture,te=ht(y),ne=fe?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,ge=y.depthTexture.format===mn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===tn)we(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ne,Te,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ne,Te,0);else if(y.depthTexture.format===mn)we(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ne,Te,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ne,Te,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gt(R){let y=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==R.depthTexture){let fe=R.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),fe){let oe=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,fe.removeEventListener("dispose",oe)};fe.addEventListener("dispose",oe),y.__depthDisposeCallback=oe}y.__boundDepthTexture=fe}if(R.depthTexture&&!y.__autoAllocateDepthBuffer)if(X)for(let fe=0;fe<6;fe++)ke(y.__webglFramebuffer[fe],R,fe);else R.texture.mipmaps.length>0?ke(y.__webglFramebuffer[0],R,0):ke(y.__webglFramebuffer,R,0);else if(X){y.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[fe]),y.__webglDepthbuffer[fe]===void 0)y.__webglDepthbuffer[fe]=n.createRenderbuffer(),nt(y.__webglDepthbuffer[fe],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=y.__webglDepthbuffer[fe];n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,be)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),nt(y.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,be)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function pt(R,y,X){let fe=i.get(R);y!==void 0&&Ie(fe.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&gt(R)}function St(R){let y=R.texture,X=i.get(R),fe=i.get(y);R.addEventListener("dispose",G),B(R);let oe=R.textures,be=R.isWebGLCubeRenderTarget===!0,Te=oe.length>1;if(Te||(fe.__webglTexture===void 0&&(fe.__webglTexture=n.createTexture()),fe.__version=y.version,o.memory.textures++),be){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(y.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ne=0;ne<y.mipmaps.length;ne++)X.__webglFramebuffer[te][ne]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(y.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<y.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(Te)for(let te=0,ne=oe.length;te<ne;te++){let ge=i.get(oe[te]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ne=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let ge=s.convert(ne.format,ne.colorSpace),N=s.convert(ne.type),re=A(ne.internalFormat,ge,N,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),ie=ht(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),nt(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(be){t.bindTexture(n.TEXTURE_CUBE_MAP,fe.__webglTexture),at(n.TEXTURE_CUBE_MAP,y);for(let te=0;te<6;te++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Ie(X.__webglFramebuffer[te][ne],R,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ne);else Ie(X.__webglFramebuffer[te],R,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(y)?S(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(Te){for(let te=0,ne=oe.length;te<ne;te++){let ge=oe[te],N=i.get(ge),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,N.__webglTexture),at(re,ge),Ie(X.__webglFramebuffer,R,ge,n.COLOR_ATTACHMENT0+te,re,0),T(ge)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,fe.__webglTexture),at(te,y),y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Ie(X.__webglFramebuffer[ne],R,y,n.COLOR_ATTACHMENT0,te,ne);else Ie(X.__webglFramebuffer,R,y,n.COLOR_ATTACHMENT0,te,0);T(y)?S(te):y.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&gt(R)}function F(R){let y=R.textures;for(let X=0,fe=y.length;X<fe;X++){let oe=y[X];if(T(oe)&&oe.mipmapsAutoUpdate===!0){let be=C(R),Te=i.get(oe).__webglTexture;t.bindTexture(be,Te),S(be),t.unbindTexture()}}}let ye=[];function qe(R){if(R.samples>0){if(we(R)===!1){let y=R.textures,X=R.width,fe=R.height,oe=n.COLOR_BUFFER_BIT,be=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Te=i.get(R),te=y.length>1;if(te)for(let ge=0;ge<y.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Te.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglFramebuffer);for(let ge=0;ge<y.length;ge++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Te.__webglColorRenderbuffer[ge]);let N=i.get(y[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,N,0)}n.blitFramebuffer(0,0,X,fe,0,0,X,fe,oe,n.NEAREST),l===!0&&(ye.length=0,ye.push(n.COLOR_ATTACHMENT0+ge),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&ye.push(be),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,ye))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let ge=0;ge<y.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,Te.__webglColorRenderbuffer[ge]);let N=i.get(y[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Te.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,N,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Te.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let y=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function ht(R){return Math.min(r.maxSamples,R.samples)}function we(R){let y=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Nt(R){let y=o.render.frame;u.get(R)!==y&&(u.set(R,y),R.update())}function $e(R,y){let X=R.colorSpace,fe=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==ys&&X!==Rn&&(_t.getTransfer(X)===Pt?(fe!==Hi||oe!==ui)&&Xe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):bt("WebGLTextures: Unsupported texture color space:",X)),y}function it(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ee,this.setTextureUnits=pe,this.setTexture2D=xe,this.setTexture2DArray=ve,this.setTexture3D=De,this.setTextureCube=Ee,this.rebindTextures=pt,this.setupRenderTarget=St,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=gt,this.setupFrameBufferTexture=Ie,this.useMultisampledRTT=we,this.dispose=H}function z_(n,e){function t(i,r=Rn){let s,o=_t.getTransfer(r);if(i===ui)return n.UNSIGNED_BYTE;if(i===uo)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ho)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Rc)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Cc)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Tc)return n.BYTE;if(i===Ac)return n.SHORT;if(i===br)return n.UNSIGNED_SHORT;if(i===co)return n.INT;if(i===Li)return n.UNSIGNED_INT;if(i===bi)return n.FLOAT;if(i===Di)return n.HALF_FLOAT;if(i===Pc)return n.ALPHA;if(i===Lc)return n.RGB;if(i===Hi)return n.RGBA;if(i===tn)return n.DEPTH_COMPONENT;if(i===mn)return n.DEPTH_STENCIL;if(i===fo)return n.RED;if(i===po)return n.RED_INTEGER;if(i===gn)return n.RG;if(i===mo)return n.RG_INTEGER;if(i===go)return n.RGBA_INTEGER;if(i===xo||i===_o||i===vo||i===Mo)if(o===Pt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===xo)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===_o)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===vo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Mo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===xo)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===_o)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===vo)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Mo)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===La||i===Da||i===Ia||i===Ua)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===La)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Da)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ia)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ua)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Fa||i===Na||i===Oa||i===Ba||i===ka||i===Ms||i===Ga)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Fa||i===Na)return o===Pt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Oa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ba)return s.COMPRESSED_R11_EAC;if(i===ka)return s.COMPRESSED_SIGNED_R11_EAC;if(i===Ms)return s.COMPRESSED_RG11_EAC;if(i===Ga)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===za||i===Ha||i===Va||i===Wa||i===Xa||i===qa||i===Ya||i===Ka||i===$a||i===Za||i===Ja||i===Qa||i===ja||i===el)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===za)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ha)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Va)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Wa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Xa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===qa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ya)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ka)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===$a)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Za)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ja)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Qa)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===ja)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===el)return o===Pt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===tl||i===il||i===nl)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===tl)return o===Pt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===il)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===nl)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===rl||i===sl||i===Ss||i===ol)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===rl)return s.COMPRESSED_RED_RGTC1_EXT;if(i===sl)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ss)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ol)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Xn?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var wE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,TE=`
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

}`,Uu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ho(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new hi({vertexShader:wE,fragmentShader:TE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new At(new Fn(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}};var Fu=class extends Vi{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,m=null,M=typeof XRWebGLBinding<"u",d=new Uu,g={},v=t.getContextAttributes(),T=null,S=null,C=[],A=[],x=new le,E=null,B=null,D=new Fi;D.viewport=new It;let L=new Fi;L.viewport=new It;let G=[D,L],W=new Au,I=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let xe=C[j];return xe===void 0&&(xe=new Co,C[j]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(j){let xe=C[j];return xe===void 0&&(xe=new Co,C[j]=xe),xe.getGripSpace()},this.getHand=function(j){let xe=C[j];return xe===void 0&&(xe=new Co,C[j]=xe),xe.getHandSpace()};function q(j){let xe=A.indexOf(j.inputSource);if(xe===-1)return;let ve=C[xe];ve!==void 0&&(ve.update(j.inputSource,j.frame,c||o),ve.dispatchEvent({type:j.type,data:j.inputSource}))}function z(){r.removeEventListener("select",q),r.removeEventListener("selectstart",q),r.removeEventListener("selectend",q),r.removeEventListener("squeeze",q),r.removeEventListener("squeezestart",q),r.removeEventListener("squeezeend",q),r.removeEventListener("end",z),r.removeEventListener("inputsourceschange",ce);for(let j=0;j<C.length;j++){let xe=A[j];xe!==null&&(A[j]=null,C[j].disconnect(xe))}I=null,H=null,d.reset();for(let j in g)delete g[j];if(e.setRenderTarget(T),p=null,f=null,h=null,r=null,S=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),B!==null){let j=B.camera;j.fov=B.fov,j.zoom=B.zoom,j.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){s=j,i.isPresenting===!0&&Xe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&Xe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&M&&(h=new XRWebGLBinding(r,t)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(j){if(r=j,r!==null){if(T=e.getRenderTarget(),r.addEventListener("select",q),r.addEventListener("selectstart",q),r.addEventListener("selectend",q),r.addEventListener("squeeze",q),r.addEventListener("squeezestart",q),r.addEventListener("squeezeend",q),r.addEventListener("end",z),r.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,De=null,Ee=null;v.depth&&(Ee=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?mn:tn,De=v.stencil?Xn:Li);let He={colorFormat:t.RGBA8,depthFormat:Ee,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(He),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new Gi(f.textureWidth,f.textureHeight,{format:Hi,type:ui,depthTexture:new Sn(f.textureWidth,f.textureHeight,De,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,ve),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new Gi(p.framebufferWidth,p.framebufferHeight,{format:Hi,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),ue.setContext(r),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ce(j){for(let xe=0;xe<j.removed.length;xe++){let ve=j.removed[xe],De=A.indexOf(ve);De>=0&&(A[De]=null,C[De].disconnect(ve))}for(let xe=0;xe<j.added.length;xe++){let ve=j.added[xe],De=A.indexOf(ve);if(De===-1){for(let He=0;He<C.length;He++)if(He>=A.length){A.push(ve),De=He;break}else if(A[He]===null){A[He]=ve,De=He;break}if(De===-1)break}let Ee=C[De];Ee&&Ee.connect(ve)}}function $(j,xe){xe===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(xe.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(r===null)return;let xe=j.near,ve=j.far;d.texture!==null&&(d.depthNear>0&&(xe=d.depthNear),d.depthFar>0&&(ve=d.depthFar)),W.near=L.near=D.near=xe,W.far=L.far=D.far=ve,(I!==W.near||H!==W.far)&&(r.updateRenderState({depthNear:W.near,depthFar:W.far}),I=W.near,H=W.far),W.layers.mask=j.layers.mask|6,D.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let De=j.parent,Ee=W.cameras;$(W,De);for(let He=0;He<Ee.length;He++)$(Ee[He],De);W.projectionMatrix.copy(D.projectionMatrix),W.projectionMatrixInverse.copy(D.projectionMatrixInverse),B===null&&j.isPerspectiveCamera&&(B={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,W,De)};function Q(j,xe,ve){ve===null?j.matrix.copy(xe.matrixWorld):(j.matrix.copy(ve.matrixWorld),j.matrix.invert(),j.matrix.multiply(xe.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(xe.projectionMatrix),j.projectionMatrixInverse.copy(xe.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=ll*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=j)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(W)},this.getCameraTexture=function(j){return g[j]};let ee=null;function pe(j,xe){if(u=xe.getViewerPose(c||o),m=xe,u!==null){let ve=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let De=!1;ve.length!==W.cameras.length&&(W.cameras.length=0,De=!0);for(let Je=0;Je<ve.length;Je++){let at=ve[Je],rt=null;if(p!==null)rt=p.getViewport(at);else{let Me=h.getViewSubImage(f,at);rt=Me.viewport,Je===0&&(e.setRenderTargetTextures(S,Me.colorTexture,Me.depthStencilTexture),e.setRenderTarget(S))}let se=G[Je];se===void 0&&(se=new Fi,se.layers.enable(Je),se.viewport=new It,G[Je]=se),se.matrix.fromArray(at.transform.matrix),se.matrix.decompose(se.position,se.quaternion,se.scale),se.projectionMatrix.fromArray(at.projectionMatrix),se.projectionMatrixInverse.copy(se.projectionMatrix).invert(),se.viewport.set(rt.x,rt.y,rt.width,rt.height),Je===0&&(W.matrix.copy(se.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),De===!0&&W.cameras.push(se)}let Ee=r.enabledFeatures;if(Ee&&Ee.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&M){h=i.getBinding();let Je=h.getDepthInformation(ve[0]);Je&&Je.isValid&&Je.texture&&d.init(Je,r.renderState)}if(Ee&&Ee.includes("camera-access")&&M){e.state.unbindTexture(),h=i.getBinding();for(let Je=0;Je<ve.length;Je++){let at=ve[Je].camera;if(at){let rt=g[at];rt||(rt=new Ho,g[at]=rt);let se=h.getCameraImage(at);rt.sourceTexture=se}}}}for(let ve=0;ve<C.length;ve++){let De=A[ve],Ee=C[ve];De!==null&&Ee!==void 0&&Ee.update(De,xe,c||o)}ee&&ee(j,xe),xe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:xe}),m=null}let ue=new Ru;ue.setAnimationLoop(pe),this.setAnimationLoop=function(j){ee=j},this.dispose=function(){}}};var AE=new st,H_=new et;H_.set(-1,0,0,0,1,0,0,0,1);function V_(n,e){function t(d,g){d.matrixAutoUpdate===!0&&d.updateMatrix(),g.value.copy(d.matrix)}function i(d,g){g.color.getRGB(d.fogColor.value,vu(n)),g.isFog?(d.fogNear.value=g.near,d.fogFar.value=g.far):g.isFogExp2&&(d.fogDensity.value=g.density)}function r(d,g,v,T,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(d,g):g.isMeshLambertMaterial?(s(d,g),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(d,g),h(d,g)):g.isMeshPhongMaterial?(s(d,g),u(d,g),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(d,g),f(d,g),g.isMeshPhysicalMaterial&&p(d,g,S)):g.isMeshMatcapMaterial?(s(d,g),m(d,g)):g.isMeshDepthMaterial?s(d,g):g.isMeshDistanceMaterial?(s(d,g),M(d,g)):g.isMeshNormalMaterial?s(d,g):g.isLineBasicMaterial?(o(d,g),g.isLineDashedMaterial&&a(d,g)):g.isPointsMaterial?l(d,g,v,T):g.isSpriteMaterial?c(d,g):g.isShadowMaterial?(d.color.value.copy(g.color),d.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(d,g){d.opacity.value=g.opacity,g.color&&d.diffuse.value.copy(g.color),g.emissive&&d.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(d.map.value=g.map,t(g.map,d.mapTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.bumpMap&&(d.bumpMap.value=g.bumpMap,t(g.bumpMap,d.bumpMapTransform),d.bumpScale.value=g.bumpScale,g.side===ei&&(d.bumpScale.value*=-1)),g.normalMap&&(d.normalMap.value=g.normalMap,t(g.normalMap,d.normalMapTransform),d.normalScale.value.copy(g.normalScale),g.side===ei&&d.normalScale.value.negate()),g.displacementMap&&(d.displacementMap.value=g.displacementMap,t(g.displacementMap,d.displacementMapTransform),d.displacementScale.value=g.displacementScale,d.displacementBias.value=g.displacementBias),g.emissiveMap&&(d.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,d.emissiveMapTransform)),g.specularMap&&(d.specularMap.value=g.specularMap,t(g.specularMap,d.specularMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest);let v=e.get(g),T=v.envMap,S=v.envMapRotation;T&&(d.envMap.value=T,d.envMapRotation.value.setFromMatrix4(AE.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(H_),d.reflectivity.value=g.reflectivity,d.ior.value=g.ior,d.refractionRatio.value=g.refractionRatio),g.lightMap&&(d.lightMap.value=g.lightMap,d.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,d.lightMapTransform)),g.aoMap&&(d.aoMap.value=g.aoMap,d.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,d.aoMapTransform))}function o(d,g){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,g.map&&(d.map.value=g.map,t(g.map,d.mapTransform))}function a(d,g){d.dashSize.value=g.dashSize,d.totalSize.value=g.dashSize+g.gapSize,d.scale.value=g.scale}function l(d,g,v,T){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,d.size.value=g.size*v,d.scale.value=T*.5,g.map&&(d.map.value=g.map,t(g.map,d.uvTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest)}function c(d,g){d.diffuse.value.copy(g.color),d.opacity.value=g.opacity,d.rotation.value=g.rotation,g.map&&(d.map.value=g.map,t(g.map,d.mapTransform)),g.alphaMap&&(d.alphaMap.value=g.alphaMap,t(g.alphaMap,d.alphaMapTransform)),g.alphaTest>0&&(d.alphaTest.value=g.alphaTest)}function u(d,g){d.specular.value.copy(g.specular),d.shininess.value=Math.max(g.shininess,1e-4)}function h(d,g){g.gradientMap&&(d.gradientMap.value=g.gradientMap)}function f(d,g){d.metalness.value=g.metalness,g.metalnessMap&&(d.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,d.metalnessMapTransform)),d.roughness.value=g.roughness,g.roughnessMap&&(d.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,d.roughnessMapTransform)),g.envMap&&(d.envMapIntensity.value=g.envMapIntensity)}function p(d,g,v){d.ior.value=g.ior,g.diffuseRoughness>0&&(d.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),g.sheen>0&&(d.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),d.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(d.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,d.sheenColorMapTransform)),g.sheenRoughnessMap&&(d.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,d.sheenRoughnessMapTransform))),g.clearcoat>0&&(d.clearcoat.value=g.clearcoat,d.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(d.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,d.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(d.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ei&&d.clearcoatNormalScale.value.negate())),g.dispersion>0&&(d.dispersion.value=g.dispersion),g.retroreflectivity>0&&(d.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(d.iridescence.value=g.iridescence,d.iridescenceIOR.value=g.iridescenceIOR,d.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(d.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,d.iridescenceMapTransform)),g.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),g.transmission>0&&(d.transmission.value=g.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(d.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,d.transmissionMapTransform)),d.thickness.value=g.thickness,g.thicknessMap&&(d.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=g.attenuationDistance,d.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(d.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(d.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=g.specularIntensity,d.specularColor.value.copy(g.specularColor),g.specularColorMap&&(d.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,d.specularColorMapTransform)),g.specularIntensityMap&&(d.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,d.specularIntensityMapTransform))}function m(d,g){g.matcap&&(d.matcap.value=g.matcap)}function M(d,g){let v=e.get(g).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function W_(n,e,t,i){let r={},s={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,r[v.id])}function a(v,T){let S=r[v.id];S===void 0&&(m(v),S=l(v),r[v.id]=S,v.addEventListener("dispose",d));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;s[v.id]!==A&&(c(v),s[v.id]=A)}function l(v){let T=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=r[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,x=S.length;A<x;A++){let E=S[A];if(Array.isArray(E))for(let B=0,D=E.length;B<D;B++)u(E[B],A,B,C);else u(E,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,T,S,C){if(f(v,T,S,C)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let E=0;for(let B=0;B<x.length;B++){let D=x[B],L=M(D,!0);h(D,v.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function h(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function f(v,T,S,C){let A=v.value,x=T+"_"+S;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let E=C[x],B=!1;for(let D=0;D<A.length;D++)p(A[D],E,D)===!0&&(B=!0);return B}return p(A,C,x)}function p(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function m(v){let T=v.uniforms,S=0,C=16;for(let x=0,E=T.length;x<E;x++){let B=Array.isArray(T[x])?T[x]:[T[x]];for(let D=0,L=B.length;D<L;D++){let G=B[D],W=Array.isArray(G.value)?G.value:[G.value],I=Array.isArray(T[x])||Array.isArray(G.value),H=S;for(let z=0,ce=W.length;z<ce;z++){let $=W[z],Q=M($,I),ee=S%C,pe=ee%Q.boundary,ue=ee+pe;S+=pe,ue!==0&&C-ue<Q.storage&&(S+=C-ue),z===0&&(H=S),S+=Q.storage}let q=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new q((S-H)/Float32Array.BYTES_PER_ELEMENT),G.__offset=H}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function M(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Xe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Xe("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function d(v){let T=v.target;T.removeEventListener("dispose",d),n.deleteBuffer(r[T.id]),delete r[T.id],delete s[T.id]}function g(){for(let v in r)n.deleteBuffer(r[v]);r={},s={}}return{bind:o,update:a,dispose:g}}var RE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),dr=null;function X_(){return dr===null&&(dr=new Bo(RE,16,16,gn,Di),dr.name="DFG_LUT",dr.minFilter=xi,dr.magFilter=xi,dr.wrapS=en,dr.wrapT=en,dr.generateMipmaps=!1,dr.needsUpdate=!0),dr}var Rl=class{constructor(e={}){let{canvas:t=Tm(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:p=ui}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let M=p,d=new Set([go,mo,po]),g=new Set([ui,Li,br,Xn,uo,ho]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],E=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=pn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,G=null,W=null,I=null,H=null;this._outputColorSpace=Ei;let q=0,z=0,ce=null,$=-1,Q=null,ee=new It,pe=new It,ue=null,j=new tt(0),xe=0,ve=t.width,De=t.height,Ee=1,He=null,ot=null,Je=new It(0,0,ve,De),at=new It(0,0,ve,De),rt=!1,se=new Qn,Me=new au,_e=!1,Be=!1,Ie=new st,nt=new O,ke=new It,gt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},pt=!1;function St(){return ce===null?Ee:1}let F=i;function ye(w,k){return t.getContext(w,k)}let qe,ht,we,Nt,$e,it,R,y,X,fe,oe,be,Te,te,ne,ge,N,re,ie,Ce,Se,Re,Qe;try{let w={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ye,!1),t.addEventListener("webglcontextrestored",ut,!1),t.addEventListener("webglcontextcreationerror",Ue,!1),F===null){let k="webgl2";if(F=ye(k,w),F===null)throw ye(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ct()}catch(w){throw t.removeEventListener("webglcontextlost",Ye,!1),t.removeEventListener("webglcontextrestored",ut,!1),t.removeEventListener("webglcontextcreationerror",Ue,!1),bt("WebGLRenderer: "+w.message),w}function ct(){qe=new t_(F),qe.init(),Se=new z_(F,qe),ht=new qx(F,qe,e,Se),we=new k_(F,qe),ht.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),W=F.createFramebuffer(),I=F.createFramebuffer(),H=F.createFramebuffer(),Nt=new r_(F),$e=new R_,it=new G_(F,qe,we,$e,ht,Se,Nt),R=new e_(D),y=new gg(F),Re=new Wx(F,y),X=new i_(F,y,Nt,Re),fe=new o_(F,X,y,Re,Nt),re=new s_(F,ht,it),ne=new Yx($e),oe=new A_(D,R,qe,ht,Re,ne),be=new V_(D,$e),Te=new L_,te=new U_(qe),N=new Vx(D,R,we,fe,m,l),ge=new B_(D,fe,ht),Qe=new W_(F,Nt,ht,we),ie=new Xx(F,qe,Nt),Ce=new n_(F,qe,Nt),Nt.programs=oe.programs,D.capabilities=ht,D.extensions=qe,D.properties=$e,D.renderLists=Te,D.shadowMap=ge,D.state=we,D.info=Nt}M!==ui&&(B=new a_(M,t.width,t.height,a,r,s));let he=new Fu(D,F);this.xr=he,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let w=qe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=qe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Ee},this.setPixelRatio=function(w){w!==void 0&&(Ee=w,this.setSize(ve,De,!1))},this.getSize=function(w){return w.set(ve,De)},this.setSize=function(w,k,J=!0){if(he.isPresenting){Xe("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=w,De=k,t.width=Math.floor(w*Ee),t.height=Math.floor(k*Ee),J===!0&&(t.style.width=w+"px",t.style.height=k+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,w,k)},this.getDrawingBufferSize=function(w){return w.set(ve*Ee,De*Ee).floor()},this.setDrawingBufferSize=function(w,k,J){ve=w,De=k,Ee=J,t.width=Math.floor(w*J),t.height=Math.floor(k*J),this.setViewport(0,0,w,k)},this.setEffects=function(w){if(M===ui){bt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let k=0;k<w.length;k++)if(w[k].isOutputPass===!0){Xe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ee)},this.getViewport=function(w){return w.copy(Je)},this.setViewport=function(w,k,J,Y){w.isVector4?Je.set(w.x,w.y,w.z,w.w):Je.set(w,k,J,Y),we.viewport(ee.copy(Je).multiplyScalar(St()).round())},this.getScissor=function(w){return w.copy(at)},this.setScissor=function(w,k,J,Y){w.isVector4?at.set(w.x,w.y,w.z,w.w):at.set(w,k,J,Y),we.scissor(pe.copy(at).multiplyScalar(St()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(w){we.setScissorTest(rt=w)},this.setOpaqueSort=function(w){He=w},this.setTransparentSort=function(w){ot=w},this.getClearColor=function(w){return w.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(w=!0,k=!0,J=!0){let Y=0;if(w){let K=!1;if(ce!==null){let Pe=ce.texture.format;K=d.has(Pe)}if(K){let Pe=ce.texture.type,Fe=g.has(Pe),Le=N.getClearColor(),Oe=N.getClearAlpha(),Ze=Le.r,ft=Le.g,Et=Le.b;Fe?(v[0]=Ze,v[1]=ft,v[2]=Et,v[3]=Oe,F.clearBufferuiv(F.COLOR,0,v)):(T[0]=Ze,T[1]=ft,T[2]=Et,T[3]=Oe,F.clearBufferiv(F.COLOR,0,T))}else Y|=F.COLOR_BUFFER_BIT}k&&(Y|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(Y|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&F.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),G=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Ye,!1),t.removeEventListener("webglcontextrestored",ut,!1),t.removeEventListener("webglcontextcreationerror",Ue,!1),N.dispose(),Te.dispose(),te.dispose(),it.dispose(),$e.dispose(),R.dispose(),fe.dispose(),X.dispose(),Re.dispose(),Qe.dispose(),oe.dispose(),he.dispose(),he.removeEventListener("sessionstart",Ll),he.removeEventListener("sessionend",er),mr.stop()};function Ye(w){w.preventDefault(),Hh("WebGLRenderer: Context Lost."),L=!0}function ut(){Hh("WebGLRenderer: Context Restored."),L=!1;let w=Nt.autoReset,k=ge.enabled,J=ge.autoUpdate,Y=ge.needsUpdate,K=ge.type;ct(),Nt.autoReset=w,ge.enabled=k,ge.autoUpdate=J,ge.needsUpdate=Y,ge.type=K}function Ue(w){bt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Mt(w){let k=w.target;k.removeEventListener("dispose",Mt),Xt(k)}function Xt(w){Yi(w),$e.remove(w)}function Yi(w){let k=$e.get(w).programs;k!==void 0&&(k.forEach(function(J){oe.releaseProgram(J)}),w.isShaderMaterial&&oe.releaseShaderCache(w))}this.renderBufferDirect=function(w,k,J,Y,K,Pe){k===null&&(k=gt);let Fe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Le=oa(w,k,J,Y,K);we.setMaterial(Y,Fe);let Oe=J.index,Ze=1;if(Y.wireframe===!0){if(Oe=X.getWireframeAttribute(J),Oe===void 0)return;Ze=2}let ft=J.drawRange,Et=J.attributes.position,Ke=ft.start*Ze,wt=(ft.start+ft.count)*Ze;Pe!==null&&(Ke=Math.max(Ke,Pe.start*Ze),wt=Math.min(wt,(Pe.start+Pe.count)*Ze)),Oe!==null?(Ke=Math.max(Ke,0),wt=Math.min(wt,Oe.count)):Et!=null&&(Ke=Math.max(Ke,0),wt=Math.min(wt,Et.count));let jt=wt-Ke;if(jt<0||jt===1/0)return;Re.setup(K,Y,Le,J,Oe);let Bt,kt=ie;if(Oe!==null&&(Bt=y.get(Oe),kt=Ce,kt.setIndex(Bt)),K.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*St()),kt.setMode(F.LINES)):kt.setMode(F.TRIANGLES);else if(K.isLine){let vi=Y.linewidth;vi===void 0&&(vi=1),we.setLineWidth(vi*St()),K.isLineSegments?kt.setMode(F.LINES):K.isLineLoop?kt.setMode(F.LINE_LOOP):kt.setMode(F.LINE_STRIP)}else K.isPoints?kt.setMode(F.POINTS):K.isSprite&&kt.setMode(F.TRIANGLES);if(K.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))kt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let vi=K._multiDrawStarts,Ve=K._multiDrawCounts,fi=K._multiDrawCount,Rt=Oe?y.get(Oe).bytesPerElement:1,xr=$e.get(Y).currentProgram.getUniforms();for(let pi=0;pi<fi;pi++)xr.setValue(F,"_gl_DrawID",pi),kt.render(vi[pi]/Rt,Ve[pi])}else if(K.isInstancedMesh)kt.renderInstances(Ke,jt,K.count);else if(J.isInstancedBufferGeometry){let vi=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ve=Math.min(J.instanceCount,vi);kt.renderInstances(Ke,jt,Ve)}else kt.render(Ke,jt)};function na(w,k,J,Y){G!==null&&w.isNodeMaterial&&G.setObject(Y,w),_e===!0&&ne.setState(w,J,!1),w.transparent===!0&&w.side===yi&&w.forceSinglePass===!1?(w.side=ei,w.needsUpdate=!0,tr(w,k,Y),w.side=An,w.needsUpdate=!0,tr(w,k,Y),w.side=yi):tr(w,k,Y)}this.compile=function(w,k,J=null){J===null&&(J=w),G!==null&&G.renderStart(w,k,J),A=te.get(J),A.init(k),E.push(A),J.traverseVisible(function(K){K.isLight&&K.layers.test(k.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),w!==J&&w.traverseVisible(function(K){K.isLight&&K.layers.test(k.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),G!==null&&G.updateLights(A.state.lightsArray),Be=this.localClippingEnabled,_e=ne.init(this.clippingPlanes,Be),_e===!0&&ne.setGlobalState(this.clippingPlanes,k),G!==null&&ge.render(A.state.shadowsArray,J,k);let Y=new Set;return w.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Pe=K.material;if(Pe)if(Array.isArray(Pe))for(let Fe=0;Fe<Pe.length;Fe++){let Le=Pe[Fe];na(Le,J,k,K),Y.add(Le)}else na(Pe,J,k,K),Y.add(Pe)}),A=E.pop(),G!==null&&G.renderEnd(),Y},this.compileAsync=function(w,k,J=null){let Y=this.compile(w,k,J);return new Promise(K=>{function Pe(){if(Y.forEach(function(Fe){let Oe=$e.get(Fe).currentProgram;(Oe===void 0||Oe.isReady())&&Y.delete(Fe)}),Y.size===0){K(w);return}setTimeout(Pe,10)}qe.get("KHR_parallel_shader_compile")!==null?Pe():setTimeout(Pe,10)})};let Us=null;function Vu(w){Us&&Us(w)}function Ll(){mr.stop()}function er(){mr.start()}let mr=new Ru;mr.setAnimationLoop(Vu),typeof self<"u"&&mr.setContext(self),this.setAnimationLoop=function(w){Us=w,he.setAnimationLoop(w),w===null?mr.stop():mr.start()},he.addEventListener("sessionstart",Ll),he.addEventListener("sessionend",er),this.render=function(w,k){if(k!==void 0&&k.isCamera!==!0){bt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(w,k);let J=he.enabled===!0&&he.isPresenting===!0,Y=B!==null&&(ce===null||J)&&B.begin(D,ce);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(k),k=he.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,k,ce),A=te.get(w,E.length),A.init(k),A.state.textureUnits=it.getTextureUnits(),E.push(A),Ie.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Me.setFromArrayCamera(k):se.setFromProjectionMatrix(Ie,ki,k.reversedDepth),Be=this.localClippingEnabled,_e=ne.init(this.clippingPlanes,Be),C=Te.get(w,x.length),C.init(),x.push(C),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Fe=D.xr.getDepthSensingMesh();Fe!==null&&gr(Fe,k,-1/0,D.sortObjects)}gr(w,k,0,D.sortObjects),C.finish(),G!==null&&G.updateLights(A.state.lightsArray),D.sortObjects===!0&&C.sort(He,ot),pt=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,pt&&N.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),_e===!0&&ne.beginShadows();let K=A.state.shadowsArray;if(ge.render(K,w,k),_e===!0&&ne.endShadows(),(Y&&B.hasRenderPass())===!1){let Fe=C.opaque,Le=C.transmissive;if(A.setupLights(),k.isArrayCamera){let Oe=k.cameras;if(Le.length>0)for(let Ze=0,ft=Oe.length;Ze<ft;Ze++){let Et=Oe[Ze];On(Fe,Le,w,Et)}pt&&N.render(w);for(let Ze=0,ft=Oe.length;Ze<ft;Ze++){let Et=Oe[Ze];ra(C,w,Et,Et.viewport)}}else Le.length>0&&On(Fe,Le,w,k),pt&&N.render(w),ra(C,w,k)}ce!==null&&z===0&&(it.updateMultisampleRenderTarget(ce),it.updateRenderTargetMipmap(ce)),Y&&B.end(D),w.isScene===!0&&w.onAfterRender(D,w,k),Re.resetDefaultState(),$=-1,Q=null,E.pop(),E.length>0?(A=E[E.length-1],it.setTextureUnits(A.state.textureUnits),_e===!0&&ne.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,G!==null&&G.renderEnd()};function gr(w,k,J,Y){if(w.visible===!1)return;if(w.layers.test(k.layers)){if(w.isGroup)J=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(k);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Fe=k.isArrayCamera?Me:se;if(!w.frustumCulled||w.intersectsFrustum(Fe)){Y&&ke.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ie);let Le=fe.update(w),Oe=w.material;Oe.visible&&C.push(w,Le,Oe,J,ke.z,null,k)}}else if(w.isMesh||w.isLine||w.isPoints){let Fe=k.isArrayCamera?Me:se;if(!w.frustumCulled||w.intersectsFrustum(Fe)){let Le=fe.update(w),Oe=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),ke.copy(w.boundingSphere.center)):(Le.boundingSphere===null&&Le.computeBoundingSphere(),ke.copy(Le.boundingSphere.center)),ke.applyMatrix4(w.matrixWorld).applyMatrix4(Ie)),Array.isArray(Oe)){let Ze=Le.groups;for(let ft=0,Et=Ze.length;ft<Et;ft++){let Ke=Ze[ft],wt=Oe[Ke.materialIndex];wt&&wt.visible&&C.push(w,Le,wt,J,ke.z,Ke,k)}}else Oe.visible&&C.push(w,Le,Oe,J,ke.z,null,k)}}}let Pe=w.children;for(let Fe=0,Le=Pe.length;Fe<Le;Fe++)gr(Pe[Fe],k,J,Y)}function ra(w,k,J,Y){let{opaque:K,transmissive:Pe,transparent:Fe}=w;A.setupLightsView(J),_e===!0&&ne.setGlobalState(D.clippingPlanes,J),Y&&we.viewport(ee.copy(Y)),K.length>0&&ni(K,k,J),Pe.length>0&&ni(Pe,k,J),Fe.length>0&&ni(Fe,k,J),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function On(w,k,J,Y){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let Ke=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new Gi(1,1,{generateMipmaps:!0,type:Ke?Di:ui,minFilter:dn,samples:Math.max(4,ht.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Pe=A.state.transmissionRenderTarget[Y.id],Fe=Y.viewport||ee;Pe.setSize(Fe.z*D.transmissionResolutionScale,Fe.w*D.transmissionResolutionScale);let Le=D.getRenderTarget(),Oe=D.getActiveCubeFace(),Ze=D.getActiveMipmapLevel();D.setRenderTarget(Pe),D.getClearColor(j),xe=D.getClearAlpha(),xe<1&&D.setClearColor(16777215,.5),D.clear(),pt&&N.render(J);let ft=D.toneMapping;D.toneMapping=pn;let Et=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),_e===!0&&ne.setGlobalState(D.clippingPlanes,Y),ni(w,J,Y),it.updateMultisampleRenderTarget(Pe),it.updateRenderTargetMipmap(Pe),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Ke=!1;for(let wt=0,jt=k.length;wt<jt;wt++){let Bt=k[wt],{object:kt,geometry:vi,material:Ve,group:fi}=Bt;if(Ve.side===yi&&kt.layers.test(Y.layers)){let Rt=Ve.side;Ve.side=ei,Ve.needsUpdate=!0,li(kt,J,Y,vi,Ve,fi),Ve.side=Rt,Ve.needsUpdate=!0,Ke=!0}}Ke===!0&&(it.updateMultisampleRenderTarget(Pe),it.updateRenderTargetMipmap(Pe))}D.setRenderTarget(Le,Oe,Ze),D.setClearColor(j,xe),Et!==void 0&&(Y.viewport=Et),D.toneMapping=ft}function ni(w,k,J){let Y=k.isScene===!0?k.overrideMaterial:null;for(let K=0,Pe=w.length;K<Pe;K++){let Fe=w[K],{object:Le,geometry:Oe,group:Ze}=Fe,ft=Fe.material;ft.allowOverride===!0&&Y!==null&&(ft=Y),Le.layers.test(J.layers)&&li(Le,k,J,Oe,ft,Ze)}}function li(w,k,J,Y,K,Pe){G!==null&&K.isNodeMaterial&&G.setObject(w,K),w.onBeforeRender(D,k,J,Y,K,Pe),w.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),K.onBeforeRender(D,k,J,Y,w,Pe),K.transparent===!0&&K.side===yi&&K.forceSinglePass===!1?(K.side=ei,K.needsUpdate=!0,D.renderBufferDirect(J,k,Y,K,w,Pe),K.side=An,K.needsUpdate=!0,D.renderBufferDirect(J,k,Y,K,w,Pe),K.side=yi):D.renderBufferDirect(J,k,Y,K,w,Pe),w.onAfterRender(D,k,J,Y,K,Pe)}function ci(w){let k=0;for(let J of w)J.texture!==null&&k++;return k}function tr(w,k,J){k.isScene!==!0&&(k=gt);let Y=$e.get(w),K=A.state.lights,Pe=A.state.shadowsArray,Fe=K.state.version,Le=oe.getParameters(w,K.state,Pe,k,J,A.state.lightProbeGridArray),Oe=oe.getProgramCacheKey(Le),Ze=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let ft=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=R.get(w.envMap||Y.environment,ft),Y.envMapRotation=Y.environment!==null&&w.envMap===null?k.environmentRotation:w.envMapRotation,Ze===void 0&&(w.addEventListener("dispose",Mt),Ze=new Map,Y.programs=Ze,Y.programVariants=new Map);let Et=Ze.get(Oe);if(Et!==void 0){if(Y.currentProgram===Et&&Y.lightsStateVersion===Fe)return sa(w,Le),Et}else Le.uniforms=oe.getUniforms(w),G!==null&&w.isNodeMaterial&&G.build(w,J,Le),w.onBeforeCompile(Le,D),Et=oe.acquireProgram(Le,Oe),Ze.set(Oe,Et),Y.uniforms=Le.uniforms;let Ke=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ke.clippingPlanes=ne.uniform),sa(w,Le),Y.needsLights=Ir(w),Y.lightsStateVersion=Fe,Y.needsLights&&(Ke.ambientLightColor.value=K.state.ambient,Ke.lightProbe.value=K.state.probe,Ke.sunLights.value=K.state.sun,Ke.sunLightShadows.value=K.state.sunShadow,Ke.directionalLights.value=K.state.directional,Ke.directionalLightShadows.value=K.state.directionalShadow,Ke.spotLights.value=K.state.spot,Ke.spotLightShadows.value=K.state.spotShadow,Ke.rectAreaLights.value=K.state.rectArea,Ke.ltc_1.value=K.state.rectAreaLTC1,Ke.ltc_2.value=K.state.rectAreaLTC2,Ke.pointLights.value=K.state.point,Ke.pointLightShadows.value=K.state.pointShadow,Ke.hemisphereLights.value=K.state.hemi,Ke.sunShadowMatrix.value=K.state.sunShadowMatrix,Ke.sunShadowCascade.value=K.state.sunShadowCascade,Ke.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ke.spotLightMatrix.value=K.state.spotLightMatrix,Ke.spotLightMap.value=K.state.spotLightMap,Ke.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=ci(A.state.lightProbeGridArray),Y.currentProgram=Et,Y.uniformsList=null,Et}function rn(w,k,J,Y,K){let Pe=$e.get(w),Fe=Pe.currentProgram.id+","+Y+","+K,Le=Pe.programVariants.get(Fe);return Le===void 0?(Le=tr(w,k,J),Pe.programVariants.set(Fe,Le)):(Pe.currentProgram=Le,Pe.uniformsList=null,Pe.outputColorSpace=Y,Pe.toneMapping=K),Le}function Dr(w){if(w.uniformsList===null){let k=w.currentProgram.getUniforms();w.uniformsList=os.seqWithValue(k.seq,w.uniforms)}return w.uniformsList}function sa(w,k){let J=$e.get(w);J.outputColorSpace=k.outputColorSpace,J.batching=k.batching,J.batchingColor=k.batchingColor,J.instancing=k.instancing,J.instancingColor=k.instancingColor,J.instancingMorph=k.instancingMorph,J.skinning=k.skinning,J.morphTargets=k.morphTargets,J.morphNormals=k.morphNormals,J.morphColors=k.morphColors,J.morphTargetsCount=k.morphTargetsCount,J.numClippingPlanes=k.numClippingPlanes,J.numIntersection=k.numClipIntersection,J.vertexAlphas=k.vertexAlphas,J.vertexTangents=k.vertexTangents,J.toneMapping=k.toneMapping}function oa(w,k,J,Y,K){k.isScene!==!0&&(k=gt),it.resetTextureUnits();let Pe=k.fog,Fe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Le=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:_t.workingColorSpace,Oe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ze=R.get(Y.envMap||Fe,Oe),ft=Y.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,Et=!!J.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ke=!!J.morphAttributes.position,wt=!!J.morphAttributes.normal,jt=!!J.morphAttributes.color,Bt=pn;Y.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Bt=D.toneMapping);let kt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,vi=kt!==void 0?kt.length:0,Ve=$e.get(Y),fi=A.state.lights;if(_e===!0&&(Be===!0||w!==Q)){let Gt=w===Q&&Y.id===$;ne.setState(Y,w,Gt)}let Rt=!1,xr=!1;Y.version===Ve.__version?Ve.needsLights&&Ve.lightsStateVersion!==fi.state.version||K.isBatchedMesh&&Ve.batching===!1||!K.isBatchedMesh&&Ve.batching===!0||K.isBatchedMesh&&Ve.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ve.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ve.instancing===!1||!K.isInstancedMesh&&Ve.instancing===!0||K.isSkinnedMesh&&Ve.skinning===!1||!K.isSkinnedMesh&&Ve.skinning===!0||K.isInstancedMesh&&Ve.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ve.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ve.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ve.instancingMorph===!1&&K.morphTexture!==null||Ve.envMap!==Ze||Y.fog===!0&&Ve.fog!==Pe||Ve.numClippingPlanes!==void 0&&(Ve.numClippingPlanes!==ne.numPlanes||Ve.numIntersection!==ne.numIntersection)||Ve.vertexAlphas!==ft||Ve.vertexTangents!==Et||Ve.morphTargets!==Ke||Ve.morphNormals!==wt||Ve.morphColors!==jt||Ve.morphTargetsCount!==vi||Ve.numLightProbeGrids!==ci(A.state.lightProbeGridArray)?Rt=!0:(Ve.outputColorSpace!==Le||Ve.toneMapping!==Bt)&&(xr=!0):(Rt=!0,Ve.__version=Y.version);let pi=Ve.currentProgram;(Rt===!0||xr===!0)&&(pi=xr===!0?rn(Y,k,K,Le,Bt):tr(Y,k,K),G&&Y.isNodeMaterial&&G.onUpdateProgram(Y,pi,Ve));let Os=!1,ir=!1,_r=!1,yt=pi.getUniforms(),ri=Ve.uniforms;if(we.useProgram(pi.program)&&(Os=!0,ir=!0,_r=!0),Y.id!==$&&($=Y.id,ir=!0),Os||Q!==w){we.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),yt.setValue(F,"projectionMatrix",w.projectionMatrix),yt.setValue(F,"viewMatrix",w.matrixWorldInverse);let di=yt.map.cameraPosition;di!==void 0&&di.setValue(F,nt.setFromMatrixPosition(w.matrixWorld)),ht.logarithmicDepthBuffer&&yt.setValue(F,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&yt.setValue(F,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,ir=!0,_r=!0)}if(Ve.needsLights&&(fi.state.sunShadowMap.length>0&&yt.setValue(F,"sunShadowMap",fi.state.sunShadowMap,it),fi.state.directionalShadowMap.length>0&&yt.setValue(F,"directionalShadowMap",fi.state.directionalShadowMap,it),fi.state.spotShadowMap.length>0&&yt.setValue(F,"spotShadowMap",fi.state.spotShadowMap,it),fi.state.pointShadowMap.length>0&&yt.setValue(F,"pointShadowMap",fi.state.pointShadowMap,it)),K.isSkinnedMesh){yt.setOptional(F,K,"bindMatrix"),yt.setOptional(F,K,"bindMatrixInverse");let Gt=K.skeleton;Gt&&(Gt.boneTexture===null&&Gt.computeBoneTexture(),yt.setValue(F,"boneTexture",Gt.boneTexture,it))}K.isBatchedMesh&&(yt.setOptional(F,K,"batchingTexture"),yt.setValue(F,"batchingTexture",K._matricesTexture,it),yt.setOptional(F,K,"batchingIdTexture"),yt.setValue(F,"batchingIdTexture",K._indirectTexture,it),yt.setOptional(F,K,"batchingColorTexture"),K._colorsTexture!==null&&yt.setValue(F,"batchingColorTexture",K._colorsTexture,it));let Ki=J.morphAttributes;if((Ki.position!==void 0||Ki.normal!==void 0||Ki.color!==void 0)&&re.update(K,J,pi),(ir||Ve.receiveShadow!==K.receiveShadow)&&(Ve.receiveShadow=K.receiveShadow,yt.setValue(F,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(ri.envMapIntensity.value=k.environmentIntensity),ri.dfgLUT!==void 0&&(ri.dfgLUT.value=X_()),ir){if(yt.setValue(F,"toneMappingExposure",D.toneMappingExposure),Ve.needsLights&&Fs(ri,_r),Pe&&Y.fog===!0&&be.refreshFogUniforms(ri,Pe),be.refreshMaterialUniforms(ri,Y,Ee,De,A.state.transmissionRenderTarget[w.id]),Ve.needsLights&&Ve.numLightProbeGrids>0){let Gt=S,di=0;for(let zi of A.state.lightProbeGridArray)zi.texture!==null&&(Gt.textures[di]=zi.texture,Gt.min[di]=zi.boundingBox.min,Gt.max[di]=zi.boundingBox.max,Gt.resolution[di]=zi.resolution,di++);for(let zi in Gt)Gt[zi].length=di;ri.probesSH.value=Gt.textures,ri.probesMin.value=Gt.min,ri.probesMax.value=Gt.max,ri.probesResolution.value=Gt.resolution}os.upload(F,Dr(Ve),ri,it)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(os.upload(F,Dr(Ve),ri,it),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&yt.setValue(F,"center",K.center),yt.setValue(F,"modelViewMatrix",K.modelViewMatrix),yt.setValue(F,"normalMatrix",K.normalMatrix),yt.setValue(F,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Gt=Y.uniformsGroups;for(let di=0,zi=Gt.length;di<zi;di++){let Dl=Gt[di];Qe.update(Dl,pi),Qe.bind(Dl,pi)}}return pi}function Fs(w,k){w.ambientLightColor.needsUpdate=k,w.lightProbe.needsUpdate=k,w.sunLights.needsUpdate=k,w.sunLightShadows.needsUpdate=k,w.directionalLights.needsUpdate=k,w.directionalLightShadows.needsUpdate=k,w.pointLights.needsUpdate=k,w.pointLightShadows.needsUpdate=k,w.spotLights.needsUpdate=k,w.spotLightShadows.needsUpdate=k,w.rectAreaLights.needsUpdate=k,w.hemisphereLights.needsUpdate=k}function Ir(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(w,k,J){let Y=$e.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),$e.get(w.texture).__webglTexture=k,$e.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:J,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,k){let J=$e.get(w);J.__webglFramebuffer=k,J.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(w,k=0,J=0){ce=w,q=k,z=J;let Y=null,K=!1,Pe=!1;if(w){let Le=$e.get(w);if(Le.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Le.__webglFramebuffer),ee.copy(w.viewport),pe.copy(w.scissor),ue=w.scissorTest,we.viewport(ee),we.scissor(pe),we.setScissorTest(ue),$=-1;return}else if(Le.__webglFramebuffer===void 0)it.setupRenderTarget(w);else if(Le.__hasExternalTextures)it.rebindTextures(w,$e.get(w.texture).__webglTexture,$e.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let ft=w.depthTexture;if(Le.__boundDepthTexture!==ft){if(ft!==null&&$e.has(ft)&&(w.width!==ft.image.width||w.height!==ft.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");it.setupDepthRenderbuffer(w)}}let Oe=w.texture;(Oe.isData3DTexture||Oe.isDataArrayTexture||Oe.isCompressedArrayTexture)&&(Pe=!0);let Ze=$e.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ze[k])?Y=Ze[k][J]:Y=Ze[k],K=!0):w.samples>0&&it.useMultisampledRTT(w)===!1?Y=$e.get(w).__webglMultisampledFramebuffer:Array.isArray(Ze)?Y=Ze[J]:Y=Ze,ee.copy(w.viewport),pe.copy(w.scissor),ue=w.scissorTest}else ee.copy(Je).multiplyScalar(Ee).floor(),pe.copy(at).multiplyScalar(Ee).floor(),ue=rt;if(J!==0&&(Y=W),we.bindFramebuffer(F.FRAMEBUFFER,Y)&&we.drawBuffers(w,Y),we.viewport(ee),we.scissor(pe),we.setScissorTest(ue),K){let Le=$e.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+k,Le.__webglTexture,J)}else if(Pe){let Le=k;for(let Oe=0;Oe<w.textures.length;Oe++){let Ze=$e.get(w.textures[Oe]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Oe,Ze.__webglTexture,J,Le)}}else if(w!==null&&J!==0){let Le=$e.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Le.__webglTexture,J)}$=-1};function Ns(w){let k=$e.get(w);return(k.__readFormat!==w.format||k.__readType!==w.type)&&(k.__readFormat=w.format,k.__readType=w.type,k.__formatReadable=ht.textureFormatReadable(w.format),k.__typeReadable=ht.textureTypeReadable(w.type)),k}this.readRenderTargetPixels=function(w,k,J,Y,K,Pe,Fe,Le=0){if(!(w&&w.isWebGLRenderTarget)){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=$e.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Fe!==void 0&&(Oe=Oe[Fe],Array.isArray(Oe)&&(Oe=Oe[0])),Oe){we.bindFramebuffer(F.FRAMEBUFFER,Oe);try{let Ze=w.textures[Le],ft=Ze.format,Et=Ze.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Le);let Ke=Ns(Ze);if(Ke.__formatReadable===!1){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ke.__typeReadable===!1){bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=w.width-Y&&J>=0&&J<=w.height-K&&F.readPixels(k,J,Y,K,Se.convert(ft),Se.convert(Et),Pe)}finally{let Ze=ce!==null?$e.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Ze)}}},this.readRenderTargetPixelsAsync=async function(w,k,J,Y,K,Pe,Fe,Le=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=$e.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Fe!==void 0&&(Oe=Oe[Fe],Array.isArray(Oe)&&(Oe=Oe[0])),Oe)if(k>=0&&k<=w.width-Y&&J>=0&&J<=w.height-K){we.bindFramebuffer(F.FRAMEBUFFER,Oe);let Ze=w.textures[Le],ft=Ze.format,Et=Ze.type;w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Le);let Ke=Ns(Ze);if(Ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let wt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,wt),F.bufferData(F.PIXEL_PACK_BUFFER,Pe.byteLength,F.STREAM_READ),F.readPixels(k,J,Y,K,Se.convert(ft),Se.convert(Et),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let jt=ce!==null?$e.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,jt);let Bt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Rm(F,Bt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,wt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Pe),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(wt),F.deleteSync(Bt),Pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,k=null,J=0){let Y=Math.pow(2,-J),K=Math.floor(w.image.width*Y),Pe=Math.floor(w.image.height*Y),Fe=k!==null?k.x:0,Le=k!==null?k.y:0;it.setTexture2D(w,0),F.copyTexSubImage2D(F.TEXTURE_2D,J,0,0,Fe,Le,K,Pe),we.unbindTexture()},this.copyTextureToTexture=function(w,k,J=null,Y=null,K=0,Pe=0){let Fe,Le,Oe,Ze,ft,Et,Ke,wt,jt,Bt=w.isCompressedTexture?w.mipmaps[Pe]:w.image;if(J!==null)Fe=J.max.x-J.min.x,Le=J.max.y-J.min.y,Oe=J.isBox3?J.max.z-J.min.z:1,Ze=J.min.x,ft=J.min.y,Et=J.isBox3?J.min.z:0;else{let yt=Math.pow(2,-K);Fe=Math.floor(Bt.width*yt),Le=Math.floor(Bt.height*yt),w.isDataArrayTexture?Oe=Bt.depth:w.isData3DTexture?Oe=Math.floor(Bt.depth*yt):Oe=1,Ze=0,ft=0,Et=0}Y!==null?(Ke=Y.x,wt=Y.y,jt=Y.z):(Ke=0,wt=0,jt=0);let kt=Se.convert(k.format),vi=Se.convert(k.type),Ve;k.isData3DTexture?(it.setTexture3D(k,0),Ve=F.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(it.setTexture2DArray(k,0),Ve=F.TEXTURE_2D_ARRAY):(it.setTexture2D(k,0),Ve=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,k.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,k.unpackAlignment);let fi=we.getParameter(F.UNPACK_ROW_LENGTH),Rt=we.getParameter(F.UNPACK_IMAGE_HEIGHT),xr=we.getParameter(F.UNPACK_SKIP_PIXELS),pi=we.getParameter(F.UNPACK_SKIP_ROWS),Os=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,Bt.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Bt.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ze),we.pixelStorei(F.UNPACK_SKIP_ROWS,ft),we.pixelStorei(F.UNPACK_SKIP_IMAGES,Et);let ir=w.isDataArrayTexture||w.isData3DTexture,_r=k.isDataArrayTexture||k.isData3DTexture;if(w.isDepthTexture){let yt=$e.get(w),ri=$e.get(k),Ki=$e.get(yt.__renderTarget),Gt=$e.get(ri.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,Ki.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,Gt.__webglFramebuffer);for(let di=0;di<Oe;di++)ir&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.get(w).__webglTexture,K,Et+di),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.get(k).__webglTexture,Pe,jt+di)),F.blitFramebuffer(Ze,ft,Ze+Fe,ft+Le,Ke,wt,Ke+Fe,wt+Le,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(K!==0||w.isRenderTargetTexture||$e.has(w)){let yt=$e.get(w),ri=$e.get(k);we.bindFramebuffer(F.READ_FRAMEBUFFER,I),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,H);for(let Ki=0;Ki<Oe;Ki++)ir?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,yt.__webglTexture,K,Et+Ki):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,yt.__webglTexture,K),_r?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ri.__webglTexture,Pe,jt+Ki):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ri.__webglTexture,Pe),K!==0?F.blitFramebuffer(Ze,ft,Ze+Fe,ft+Le,Ke,wt,Ke+Fe,wt+Le,F.COLOR_BUFFER_BIT,F.NEAREST):_r?F.copyTexSubImage3D(Ve,Pe,Ke,wt,jt+Ki,Ze,ft,Fe,Le):F.copyTexSubImage2D(Ve,Pe,Ke,wt,Ze,ft,Fe,Le);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else _r?w.isDataTexture||w.isData3DTexture?F.texSubImage3D(Ve,Pe,Ke,wt,jt,Fe,Le,Oe,kt,vi,Bt.data):k.isCompressedArrayTexture?F.compressedTexSubImage3D(Ve,Pe,Ke,wt,jt,Fe,Le,Oe,kt,Bt.data):F.texSubImage3D(Ve,Pe,Ke,wt,jt,Fe,Le,Oe,kt,vi,Bt):w.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Pe,Ke,wt,Fe,Le,kt,vi,Bt.data):w.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Pe,Ke,wt,Bt.width,Bt.height,kt,Bt.data):F.texSubImage2D(F.TEXTURE_2D,Pe,Ke,wt,Fe,Le,kt,vi,Bt);we.pixelStorei(F.UNPACK_ROW_LENGTH,fi),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Rt),we.pixelStorei(F.UNPACK_SKIP_PIXELS,xr),we.pixelStorei(F.UNPACK_SKIP_ROWS,pi),we.pixelStorei(F.UNPACK_SKIP_IMAGES,Os),Pe===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&F.generateMipmap(Ve),we.unbindTexture()},this.initRenderTarget=function(w){$e.get(w).__webglFramebuffer===void 0&&it.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?it.setTextureCube(w,0):w.isData3DTexture?it.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?it.setTexture2DArray(w,0):it.setTexture2D(w,0),we.unbindTexture()},this.resetState=function(){q=0,z=0,ce=null,we.reset(),Re.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var q_="#f4efe2";function Y_(n){let e=document.createElement("canvas");e.width=512,e.height=256;let t=e.getContext("2d");if(!t)return e;if(t.fillStyle=n.striped?q_:n.colour,t.fillRect(0,0,512,256),n.striped&&(t.fillStyle=n.colour,t.fillRect(0,256*(.5-.2),512,2*.2*256)),n.spotted&&PE(t,"#c4202b"),n.label)for(let i of[.25,.75])CE(t,i*512,256/2,n.label);return e}function CE(n,e,t,i){n.fillStyle=q_,n.beginPath(),n.arc(e,t,.155*256,0,2*Math.PI),n.fill();let r=i.length>2?30:i.length>1?46:56;n.fillStyle="#16181a",n.font=`700 ${r}px "Helvetica Neue", Arial, "Liberation Sans", sans-serif`,n.textAlign="center",n.textBaseline="middle",n.fillText(i,e,t+.04*r,2*.155*256*.82),/^[69]$/.test(i)&&n.fillRect(e-.3*r,t+.44*r,.6*r,3)}function PE(n,e){n.fillStyle=e;for(let i of[0,.25,.5,.75,1])n.beginPath(),n.arc(i*512,256/2,12.8,0,2*Math.PI),n.fill();n.fillRect(0,0,512,12.8),n.fillRect(0,256-12.8,512,12.8)}var LE=`
varying vec3 polishNormal;
varying vec3 polishAt;
void main() {`,DE=`
  vec4 polishPlace = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
    polishPlace = instanceMatrix * polishPlace;
  #endif
  polishAt = (modelMatrix * polishPlace).xyz;
  polishNormal = inverseTransformDirection(transformedNormal, viewMatrix);
}`;function IE(n,e){let{cloth:t,floor:i}=n,[r,s]=[(t.x0+t.x1)/2,(t.y0+t.y1)/2],[o,a]=[t.x1-t.x0,t.y1-t.y0],l=Math.max(o,a),c=h=>h.toFixed(5),u=a>=o?[.12,.5]:[.5,.12];return`
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
}`}function Nu(n,e,t,i){let r=n.onBeforeCompile.bind(n);n.onBeforeCompile=(s,o)=>{r(s,o),s.vertexShader=s.vertexShader.replace("void main() {",LE).replace(/\}\s*$/,DE),s.fragmentShader=s.fragmentShader.replace("void main() {",`${IE(e,i)}
void main() {`).replace("#include <opaque_fragment>",`vec3 polishFrom = normalize(polishAt - cameraPosition);
       vec3 polishUp = normalize(polishNormal);
       float polishMirror = 0.04 + 0.96 * pow(1.0 - clamp(dot(-polishFrom, polishUp), 0.0, 1.0), 5.0);
       outgoingLight += ${t.toFixed(3)} * polishMirror * polishRoom(polishAt, reflect(polishFrom, polishUp));
       #include <opaque_fragment>`)},n.customProgramCacheKey=()=>`polish ${t} ${i}`}function K_(n){let e=n>>>0;return()=>(e=Math.imul(e,1664525)+1013904223>>>0,e/4294967296)}function Rf(n,e){let t=document.createElement("canvas");return t.width=n,t.height=e,[t,t.getContext("2d")]}function $_(n){let e=new es(n);return e.wrapS=Yr,e.wrapT=Yr,e.colorSpace=Ei,e.anisotropy=8,e}function Z_(){let[n,e]=[1024,128],[t,i]=Rf(n,e);if(i){let r=K_(7);i.fillStyle="#6b3a20",i.fillRect(0,0,n,e);for(let s=0;s<420;s+=1){let o=r()*e,a=r()<.6;i.strokeStyle=a?`rgba(28,10,4,${.05+.16*r()})`:`rgba(190,110,60,${.03+.1*r()})`,i.lineWidth=.5+1.6*r();let[l,c,u]=[1+3*r(),1+Math.floor(2*r()),6.3*r()];i.beginPath();for(let h=0;h<=n;h+=16)i.lineTo(h,o+l*Math.sin(u+c*2*Math.PI*h/n));i.stroke()}}return $_(t)}function J_(){let[e,t]=Rf(256,256);if(t){let i=K_(11);t.fillStyle="#e9e9e9",t.fillRect(0,0,256,256);for(let r=0;r<9e3;r+=1){let s=i()<.5?0:255;t.fillStyle=`rgba(${s},${s},${s},${.05*i()+.01})`,t.fillRect(i()*256,i()*256,1+2*i(),1)}}return $_(e)}function Q_(){let[e,t]=Rf(64,64);if(t){let i=t.createRadialGradient(32,32,0,32,32,32);i.addColorStop(0,"rgba(0,0,0,0.75)"),i.addColorStop(.45,"rgba(0,0,0,0.5)"),i.addColorStop(1,"rgba(0,0,0,0)"),t.fillStyle=i,t.fillRect(0,0,64,64)}return new es(e)}var Pf=64,UE=.12,[as,FE,Cf,Cl]=[new O,new O,new Ii,new st],ev=new st().makeScale(0,0,0),Ou=class{constructor(e){this.stage=e;let{balls:t}=e.data,i=t.length>Pf,r=i?new $o(1,20,14):new $o(1,48,32);i?(this.instances=new Jn(r,j_(e,{}),t.length),t.forEach((o,a)=>this.instances?.setColorAt(a,new tt(Br(o.id,a).colour))),this.instances.castShadow=!0,this.instances.frustumCulled=!1,this.group.add(this.instances)):t.forEach((o,a)=>{let l=new es(Y_(Br(o.id,a)));l.colorSpace=Ei,l.anisotropy=8;let c=new At(r,j_(e,{map:l}));c.castShadow=!0,c.receiveShadow=!0,this.meshes.push(c),this.group.add(c)});let s=new Un({map:Q_(),transparent:!0,depthWrite:!1,opacity:.8});this.shades=new Jn(new Fn(2.5,2.5),s,t.length),this.shades.frustumCulled=!1,this.shades.renderOrder=1,this.group.add(this.shades)}stage;group=new nn;meshes=[];instances=null;shades;show(e,t,i,r){let{stage:s,meshes:o,instances:a,shades:l}=this,{positions:c,orientations:u,present:h,run:f}=e;s.radii.forEach((p,m)=>{as.fromArray(c,3*m);let M=h[m]?0:(i-f.leaves[m])/(UE*r),d=M>=0&&M<1;as.z-=2.2*p*Math.max(0,M)**2,Cf.fromArray(u,4*m).multiply(t),Cl.compose(as,Cf,FE.setScalar(d?p:0)),a?a.setMatrixAt(m,Cl):(o[m].visible=d,o[m].position.copy(as),o[m].quaternion.copy(Cf),o[m].scale.setScalar(p)),h[m]&&Cl.makeScale(p,p,p).setPosition(as.x,as.y,s.floor+.02),l.setMatrixAt(m,h[m]?Cl:ev)}),l.instanceMatrix.needsUpdate=!0,a&&(a.instanceMatrix.needsUpdate=!0)}};function j_(n,e){let t=new yn(e);return Nu(t,n,1,.012),t}var NE=`
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
}`,OE=`
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
}`,Bu=class{constructor(e,t){this.stage=e;let i=e.data.balls.length,{cloth:r,beats:s}=ln(t),o=new hi({vertexShader:NE,fragmentShader:OE,uniforms:{colour:{value:new tt(r)},beats:{value:s}},transparent:!0,depthWrite:!1}),a=new $o(1,i>Pf?18:36,i>Pf?12:24);this.seen=new hr(new Float32Array(i),1),this.seen.setUsage(bm),a.setAttribute("seen",this.seen),this.mesh=new Jn(a,o,i),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}stage;mesh;seen;show(e,t){let{mesh:i,seen:r,stage:s}=this;s.radii.forEach((o,a)=>{let[l,c]=[e.present[a]===1,t.present[a]===1],u=l?c?Vl(e.positions,t.positions,a):1:0;r.array[a]=u,as.fromArray(e.positions,3*a),i.setMatrixAt(a,u>0?Cl.makeScale(1.02*o,1.02*o,1.02*o).setPosition(as):ev)}),r.needsUpdate=!0,i.instanceMatrix.needsUpdate=!0}},ku=class{constructor(e){this.stage=e;let t=new Un({color:"#ffe98a",transparent:!0,opacity:.95,depthTest:!1,depthWrite:!1}),i=new ns(1.02,1.2,64);this.called=Array.from({length:8},()=>new At(i,t)),this.chosen=new At(new ns(1.12,1.2,64),new Un({color:"#ffffff",transparent:!0,opacity:.7,depthWrite:!1})),this.called.forEach(r=>r.renderOrder=5),this.group.add(...this.called,this.chosen)}stage;group=new nn;called;chosen;show(e,t,i){this.called.forEach((r,s)=>this.put(r,e,t[s]??-1)),this.put(this.chosen,e,i)}put(e,t,i){if(e.visible=i>=0&&t.present[i]===1,e.visible){let r=this.stage.radii[i];e.scale.setScalar(r),e.position.set(t.positions[3*i],t.positions[3*i+1],this.stage.floor+.03)}}};var tv=26,BE=.92,kE=1.5,GE=420,Gu=class{constructor(e,t,i){this.sight=e;this.floor=t;this.still=i}sight;floor;still;pose={tilt:0,turn:0,zoom:1,x:0,y:0};from=null;goal=null;began=0;lying=!0;look(e){this.to({tilt:e==="above"?0:BE,turn:e==="above"?0:-.2,zoom:1,x:0,y:0})}close(e){let{tilt:t,turn:i}=this.goal??this.pose;this.to({tilt:t,turn:i,...e?zl(this.sight,e):{zoom:1,x:0,y:0}})}orbit(e,t){let i=this.settle();i.turn+=e,i.tilt=Math.min(kE,Math.max(0,i.tilt+t))}zoom(e){let t=this.settle();t.zoom=Math.min(2,Math.max(.04,t.zoom*e))}pan(e,t,i){let r=this.settle(),s=2*Math.tan(tv*Math.PI/360)*i.position.distanceTo(this.target(new O)),o=this.heading();r.x+=s*(e*Math.sin(o)+t*Math.cos(o)),r.y+=s*(-e*Math.cos(o)+t*Math.sin(o))}place(e,t){let i=this.ease(t),r=this.heading(),{tilt:s,zoom:o}=this.pose,a=new O(Math.cos(r),Math.sin(r),0),l=a.clone().multiplyScalar(-Math.sin(s));l.z=Math.cos(s);let c=a.clone().multiplyScalar(Math.cos(s));c.z=Math.sin(s);let u=new O(Math.sin(r),-Math.cos(r),0),h=this.target(new O),f=this.fit(e.aspect,u,c,l);return h.addScaledVector(c,f.rise*o),e.up.copy(c),e.position.copy(h).addScaledVector(l,f.distance*o),e.near=Math.max(.05,.02*f.distance*o),e.far=6*f.distance*Math.max(1,o)+50,e.lookAt(h),e.updateProjectionMatrix(),e.updateMatrixWorld(),i}heading(){return(this.lying?Math.PI:Math.PI/2)+this.pose.turn}target(e){let{sight:t,floor:i,pose:r}=this;return e.set((t.x0+t.x1)/2+r.x,(t.y0+t.y1)/2+r.y,i)}fit(e,t,i,r){let{sight:s}=this,[o,a]=[(s.x1-s.x0)/2,(s.y1-s.y0)/2],l=Math.tan(tv*Math.PI/360),c=l*e,h=[-1,1].flatMap(m=>[-1,1].flatMap(M=>[-2.6,2].map(d=>new O(m*o,M*a,d)))).map(m=>({x:m.dot(t),y:m.dot(i),z:m.dot(r)})),f=0,p=0;for(let m=0;m<6;m+=1){p=Math.max(...h.map(d=>d.z+Math.max(Math.abs(d.x)/c,Math.abs(d.y-f)/l)));let M=h.map(d=>(d.y-f)/(p-d.z));f+=(Math.max(...M)+Math.min(...M))/2*p*.8}return p=Math.max(...h.map(m=>m.z+Math.max(Math.abs(m.x)/c,Math.abs(m.y-f)/l))),{distance:p*1.04,rise:f}}to(e){if(this.still()){this.pose=e,this.goal=null;return}this.from={...this.pose},this.goal=e,this.began=performance.now()}settle(){return this.goal=null,this.pose}ease(e){let{from:t,goal:i}=this;if(!t||!i)return!1;let r=Math.min(1,Math.max(0,(e-this.began)/GE)),s=r*r*(3-2*r),o=(a,l)=>a+s*(l-a);return this.pose={tilt:o(t.tilt,i.tilt),turn:o(t.turn,i.turn),zoom:o(t.zoom,i.zoom),x:o(t.x,i.x),y:o(t.y,i.y)},r>=1&&(this.goal=null),r<1}};var zE=.2,HE=`
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
}`,VE=`
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
}`,zu=class{mesh;material;constructor(e,t,i){let[r,s,o,a,l]=[[],[],[],[],[]],c=e.floor+(i?.016:.012);t.paths.forEach((f,p)=>{let m=i?new tt(ln(t.index).cloth):new tt(Br(e.data.balls[p].id,p).colour).lerp(new tt("#ffffff"),.25),M=Nl(f,t.leaves[p]),d=0;for(let g=0;g+5<M.length;g+=3){let[v,T,S,C,A,x]=M.subarray(g,g+6),E=Math.hypot(A-T,x-S);if(E<1e-6)continue;let B=zE/2*(i?.8:1),[D,L]=[-(x-S)/E*B,(A-T)/E*B],G=r.length/3;r.push(T+D,S+L,c,T-D,S-L,c,A+D,x+L,c,A-D,x-L,c),s.push(v,v,C,C),o.push(d,d,d+E,d+E),a.push(...[0,1,2,3].flatMap(()=>[m.r,m.g,m.b])),l.push(G,G+1,G+2,G+2,G+1,G+3),d+=E}});let u=new zt;u.setAttribute("position",new mt(r,3)),u.setAttribute("when",new mt(s,1)),u.setAttribute("way",new mt(o,1)),u.setAttribute("tint",new mt(a,3)),u.setIndex(l);let h=Math.max(1e-9,e.end/5);this.material=new hi({vertexShader:HE,fragmentShader:VE,uniforms:{now:{value:0},fade:{value:h},dash:{value:i?1.4:0},strength:{value:i?.85:.8}},transparent:!0,depthWrite:!1,side:yi}),this.mesh=new At(u,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=2}show(e){this.material.uniforms.now.value=e}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}},WE=`
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
}`,XE=`
varying vec2 at;
varying float age;
void main() {
  float d = length(at);
  float ring = smoothstep(0.7, 0.76, d) * smoothstep(1.0, 0.94, d);
  if (ring < 0.01) discard;
  gl_FragColor = vec4(1.0, 0.97, 0.85, ring * (1.0 - age) * 0.9);
}`,Hu=class{mesh;material;constructor(e,t,i){let r=Ol(e,t);this.material=new hi({vertexShader:WE,fragmentShader:XE,uniforms:{now:{value:0},life:{value:ha},grows:{value:i?0:1}},transparent:!0,depthWrite:!1});let s=new Fn(2,2);s.setAttribute("when",new hr(Float32Array.from(r,o=>o.at),1)),this.mesh=new Jn(s,this.material,Math.max(1,r.length)),this.mesh.count=r.length,this.mesh.frustumCulled=!1,this.mesh.renderOrder=3,r.forEach((o,a)=>this.mesh.setMatrixAt(a,new st().makeScale(o.r,o.r,1).setPosition(o.x,o.y,e.floor+.025)))}show(e,t){this.material.uniforms.now.value=e,this.material.uniforms.life.value=ha*t}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}};var qE="#0f6048",iv=1.28,ia=1.62,YE=.3,KE=.45;function nv(n){let e=new nn;e.position.z=n.floor,e.add($E(n)),n.table&&e.add(JE(n.table,n),jE(n.table,n),tw(n.table,n));for(let t of n.pockets)e.add(...iw(t.x,t.y,t.r));return e}function $E(n){let e=n.table?Qi(n.cloth,1.25+.5*2.9):n.cloth,t=new fr([new le(e.x0,e.y0),new le(e.x1,e.y0),new le(e.x1,e.y1),new le(e.x0,e.y1)]),i=(a,l,c)=>a-c>e.x0&&a+c<e.x1&&l-c>e.y0&&l+c<e.y1;for(let{x:a,y:l,r:c}of n.pockets.filter(u=>i(u.x,u.y,u.r)))t.holes.push(new Pr().absarc(a,l,c,0,2*Math.PI,!0));let r=J_();r.repeat.set(1/9,1/9);let s=new yn({color:Bl,map:r});ZE(s,n.cloth);let o=new At(new _u(t,40),s);return o.receiveShadow=!0,o}function ZE(n,e){let t=(s,o)=>`vec2(${s.toFixed(5)}, ${o.toFixed(5)})`,i=t((e.x0+e.x1)/2,(e.y0+e.y1)/2),r=t((e.x1-e.x0)/2,(e.y1-e.y0)/2);n.onBeforeCompile=s=>{s.vertexShader=s.vertexShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
litAt = position.xy;`),s.fragmentShader=s.fragmentShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <map_fragment>",`#include <map_fragment>
       vec2 off = abs(litAt - ${i}) / ${r};
       diffuseColor.rgb *= mix(1.12, 0.66, smoothstep(0.25, 1.5, length(off)));`)}}function JE(n,e){let t=e.pockets.map(o=>({...o,r:o.r+YE})),i=[];for(let o of qs(n,t).straights)QE(o,i);let r=new zt;r.setAttribute("position",new mt(i,3)),r.computeVertexNormals();let s=new At(r,new yn({color:qE,side:yi}));return s.castShadow=!0,s.receiveShadow=!0,s}function QE(n,e){let{x0:t,y0:i,x1:r,y1:s}=n,o=Math.hypot(r-t,s-i),[a,l]=[(r-t)/o,(s-i)/o],[c,u]=[l,-a],h=g=>(g?KE:1)*1.25,f=(g,v,T)=>[t+g*a+v*c,i+g*l+v*u,T],p=[[.22,0],[0,iv-.2],[.1,iv],[1.25,ia-.02],[1.25,0]],m=g=>-g/1.25*h(n.pocketBefore),M=g=>o+g/1.25*h(n.pocketAfter),d=(g,v,T,S)=>{e.push(...g,...v,...T,...g,...T,...S)};for(let g=0;g<3;g+=1){let[[v,T],[S,C]]=[p[g],p[g+1]];d(f(m(v),v,T),f(m(S),S,C),f(M(S),S,C),f(M(v),v,T))}for(let g of[m,M]){let[v,T,S,C,A]=p.map(([x,E])=>f(g(x),x,E));d(v,T,S,C),e.push(...v,...C,...A)}}function jE(n,e){let t=Qi(n,1.25+2.9),i=2.4,r=new fr;r.moveTo(t.x0+i,t.y0);for(let[u,h,f]of[[t.x1-i,t.y0+i,-.5],[t.x1-i,t.y1-i,0],[t.x0+i,t.y1-i,.5],[t.x0+i,t.y0+i,1]])r.absarc(u,h,i,f*Math.PI,(f+.5)*Math.PI,!1);let s=qs(Qi(n,1.25),rv(e)).points;r.holes.push(new Pr(s.map(([u,h])=>new le(u,h)).reverse()));let o=.22,a=new xu(r,{depth:ia+3-2*o,bevelSize:o,bevelThickness:o,bevelOffset:-o,bevelSegments:3,curveSegments:12});a.translate(0,0,-3+o);let l=new yn({map:Z_()});ew(l,n),Nu(l,e,.55,.12);let c=new At(a,l);return c.castShadow=!0,c.receiveShadow=!0,c}function ew(n,e){let t=[(e.x0+e.x1)/2,(e.y0+e.y1)/2],i=[(e.x1-e.x0)/2,(e.y1-e.y0)/2],r=s=>`vec2(${s.map(o=>o.toFixed(6)).join(",")})`;n.onBeforeCompile=s=>{s.vertexShader=s.vertexShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
grainAt = position;`),s.fragmentShader=s.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <map_fragment>",`vec2 far = abs(grainAt.xy - ${r(t)}) - ${r(i)};
       vec2 grainUv = far.x > far.y ? vec2(grainAt.y / 34.0, (grainAt.x + grainAt.z) / 7.0) : vec2(grainAt.x / 34.0 + 0.37, (grainAt.y + grainAt.z) / 7.0);
       diffuseColor *= texture2D(map, grainUv);`)}}function rv(n){return n.pockets.map(e=>({...e,r:e.r+.1}))}function tw(n,e){let t=kl(n,e),i=new Jn(new gl(.26,4),new yn({color:"#efe6d2"}),Math.max(1,t.length));return i.count=t.length,t.forEach(([r,s],o)=>i.setMatrixAt(o,new st().makeTranslation(r,s,ia+.012))),i}function iw(n,e,t){let i=new At(new xl(t,t*.92,2.6,40,1,!0).rotateX(Math.PI/2),new yn({color:"#15110e",side:yi}));i.position.set(n,e,-1.3);let r=new At(new gl(t,40),new Un({color:"#050505"}));r.position.set(n,e,-2.5);let s=new At(new ns(t*.985,t*1.06,48),new yn({color:"#0b0a09"}));return s.position.set(n,e,.012),[i,r,s]}function sv(n){let e=new nn;if(e.position.z=n.floor,!n.table)return e;let t=new yn({color:"#17130f",side:yi});for(let i of qs(Qi(n.table,1.25),rv(n)).arcs){let{x:r,y:s,r:o}=i.pocket,a=new At(new xl(.985*o,.985*o,ia+1,40,1,!0,0,i.sweep).rotateX(Math.PI/2),t);a.position.set(r,s,(ia-1)/2+.02),a.rotation.z=i.from+Math.PI/2;let l=new At(new ns(o-.02,o+.42,40,1,i.from,i.sweep),t);l.position.set(r,s,ia+.02),e.add(a,l)}return e}function ov(n){let e=Qi(n.cloth,.4),t=new At(new Fn(e.x1-e.x0,e.y1-e.y0),new Un({color:"#0a3a2c"}));return t.position.set((e.x0+e.x1)/2,(e.y0+e.y1)/2,n.floor-.05),t}var nw=2,rw=45,sw=2e3,Lf=12,ow=.75,Pl=class{constructor(e,t,i){this.stage=e;this.still=t;this.canvas=document.createElement("canvas");let r=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!r)throw new Error("this browser has no WebGL 2");this.renderer=new Rl({canvas:this.canvas,context:r}),this.canvas.addEventListener("webglcontextlost",a=>{a.preventDefault(),i()});let{renderer:s,scene:o}=this;s.setClearColor(0,0),s.toneMapping=lo,s.toneMappingExposure=.95,s.shadowMap.enabled=!0,s.autoClear=!1,o.add(new yl("#fff6e8","#3a8a6a",1.75)),this.lamp(),o.add(nv(e),sv(e)),e.table||o.add(ov(e)),this.solid=new Ou(e),this.halos=new ku(e),o.add(this.solid.group,this.halos.group);for(let a of e.runs){let l=new Bu(e,a.index);this.ghostBalls.push(l),o.add(l.mesh)}this.eye=new Gu(e.sight,e.floor,t)}stage;still;canvas;renderer;scene=new ul;camera=new Fi(26,1);eye;solid;halos;ghostBalls=[];trails=new Map;rings=new Map;base=new Ii;light=new bl("#fff1dc",2.7);width=1;height=1;slow=0;last=0;drawn=null;look(e){this.eye.look(e.camera==="free"?"free":"above")}close(e){this.eye.close(e)}orbit(e,t){this.eye.orbit(-3*e,-2.4*t)}zoom(e){this.eye.zoom(e)}pan(e,t){this.eye.pan(e,t,this.camera)}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t);let i=window.devicePixelRatio||1;this.renderer.setPixelRatio(this.slow>=Lf?ow*Math.min(1,i):Math.min(nw,i)),this.renderer.setSize(this.width,this.height,!1)}draw(e,t,i,r){let{renderer:s,camera:o,eye:a}=this,l=performance.now();this.watch(l,r),this.drawn={frame:e,choice:t},s.setScissorTest(!1),s.clear(),s.setScissorTest(!0);let c=!1,u=kr(t),h=this.cells(u.length);return u.forEach((f,p)=>{let{x:m,y:M,width:d,height:g}=h[p];o.aspect=d/g,c=a.place(o,l)||c,this.arrange(e,t,f,i);let v=this.height-M-g;s.setViewport(m,v,d,g),s.setScissor(m,v,d,g),s.render(this.scene,o)}),c}pick(e,t){if(!this.drawn)return-1;let{frame:i,choice:r}=this.drawn,s=kr(r),o=this.cells(s.length),a=Hl(o,e,t);if(a<0)return-1;let{x:l,y:c,width:u,height:h}=o[a];this.camera.aspect=u/h,this.eye.place(this.camera,performance.now());let f=i.scatters[s[a]],p=new O,m={ball:-1,distance:18};for(let M=0;M<f.present.length;M+=1){p.fromArray(f.positions,3*M).project(this.camera);let d=Math.hypot(l+(p.x+1)/2*u-e,c+(1-p.y)/2*h-t);f.present[M]&&d<m.distance&&(m={ball:M,distance:d})}return m.ball}dispose(){this.scene.traverse(e=>{if(e instanceof At){let t=e;t.geometry.dispose();for(let i of[t.material].flat())i.map?.dispose(),i.dispose()}}),this.renderer.dispose(),this.canvas.remove()}arrange(e,t,i,r){let s=e.scatters[i];this.solid.show(s,this.base,e.time,r),this.halos.show(s,t.called,t.ball);let o=Gl(t,i);this.ghostBalls.forEach((a,l)=>{a.mesh.visible=o.includes(l),a.mesh.visible&&a.show(e.scatters[l],s)});for(let a of this.trails.values())a.mesh.visible=!1;if(t.trails)for(let a of[i,...o]){let l=this.trailsOf(a,a!==i);l.mesh.visible=!0,l.show(e.time)}for(let a of this.rings.values())a.mesh.visible=!1;if(t.marks){let a=this.ringsOf(i);a.mesh.visible=!0,a.show(e.time,r)}}trailsOf(e,t){let i=`${e} ${t}`,r=this.trails.get(i);return r||(r=new zu(this.stage,this.stage.runs[e],t),this.trails.set(i,r),this.scene.add(r.mesh)),r}ringsOf(e){let t=this.rings.get(e);return t||(t=new Hu(this.stage,this.stage.runs[e],this.still()),this.rings.set(e,t),this.scene.add(t.mesh)),t}cells(e){let{cells:t,lying:i}=hs(this.stage.sight,e,this.width,this.height);return this.lie(i),t}lie(e){this.eye.lying=e;let t=.3;e?this.base.setFromAxisAngle(new O(0,1,0),t).multiply(new Ii().setFromAxisAngle(new O(0,0,1),Math.PI/2)):this.base.setFromAxisAngle(new O(1,0,0),t)}lamp(){let{light:e,scene:t,stage:i}=this,{cloth:r}=i,[s,o]=[(r.x0+r.x1)/2,(r.y0+r.y1)/2],a=Math.hypot(r.x1-r.x0,r.y1-r.y0)/2+6;e.position.set(s-.25*a,o-.3*a,i.floor+1.6*a),e.target.position.set(s,o,i.floor),e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.radius=3,e.shadow.bias=-4e-4,e.shadow.normalBias=.04;let l=e.shadow.camera;[l.left,l.right,l.bottom,l.top]=[-a,a,-a,a],l.near=.2*a,l.far=3.2*a,t.add(e,e.target)}watch(e,t){let i=e-this.last;this.last=e,!(!t||i>sw||this.slow>=Lf)&&(this.slow=i>rw?this.slow+1:Math.max(0,this.slow-1),this.slow>=Lf&&(this.light.castShadow=!1,this.resize(this.width,this.height)))}};var aw=9;function av(n,e,t={}){let i=new Wl(Math.max(0,...e.runs.map(l=>l.end))),r=me("section",{class:"rp","aria-label":`Replay of ${e.scene.title}`},me("p",{class:"rp-wait"},"Unpacking the replay …"));n.append(r),n.classList.add("rp-live");let s=null,o=!1,a=ap(e).then(l=>{o||(s=new Df(r,tp(e,l),i,t))}).catch(l=>{throw r.replaceChildren(me("p",{class:"rp-wait",role:"alert"},`This replay cannot be shown: ${l instanceof Error?l.message:String(l)}`)),n.classList.remove("rp-live"),l});return a.catch(()=>{}),{ready:a,seek:l=>i.seek(l),play:()=>i.play(),pause:()=>i.pause(),time:()=>i.time,destroy:()=>{o=!0,i.stop(),s?.destroy(),r.remove(),n.classList.remove("rp-live")}}}var Df=class{constructor(e,t,i,r){this.element=e;this.stage=t;this.clock=i;let{data:s,runs:o}=t;this.frame=new $l(t);let a=Math.max(0,s.runs.findIndex(u=>u.reference)),l=s.balls.findIndex(u=>u.id==="cue");this.choice={camera:"above",solid:a,shown:o.map(()=>!0),apart:!1,trails:!0,marks:!0,ball:Math.max(0,l),called:[]},this.view=r.flat?null:this.world(),this.solidView=this.view!==null,this.view??=new Gr(t,this.still),this.solidView||(this.choice.camera="flat"),this.controls=new Kl(t,i,this,this.solidView),this.legend=new Jl(t,this),this.readout=new dc(t),this.plots=new pc(t,this,r.growing??!1);let c=up();this.picture.setAttribute("aria-label",`The table of ${s.scene.title}; the same in numbers under “Where the balls are now”`),this.picture.append(this.view.canvas,this.captions),e.replaceChildren(this.picture,this.controls.element,this.banner,this.status,this.legend.element,this.plots.element,this.readout.element,c),cp(this.picture,{view:()=>this.view,again:this.ask,choose:u=>this.follow(u)}),hp(e,{actions:this,view:()=>this.view,end:()=>t.end,camera:()=>this.choice.camera,nextCamera:()=>this.nextCamera(),toggleTrails:()=>this.trails(!this.choice.trails),again:this.ask,keys:c}),this.sizes=new ResizeObserver(()=>this.resize()),this.sizes.observe(e),i.listen(this.tick),this.resize(),this.view.look(this.choice),this.changed(),this.controls.mark(this.events()),this.tick(),r.autoplay&&!this.calm.matches&&i.play()}element;stage;clock;frame;choice;controls;legend;readout;plots;picture=me("div",{class:"rp-picture",tabindex:0,role:"group"});captions=me("div",{class:"rp-captions"});banner=me("p",{class:"rp-banner",hidden:!0});status=me("p",{class:"rp-status",role:"status"});sizes;calm=matchMedia("(prefers-reduced-motion: reduce)");view=null;waiting=null;called=-1;asked=0;solidView=!0;destroy(){cancelAnimationFrame(this.asked),this.sizes.disconnect(),this.plots.destroy(),this.view?.dispose(),this.waiting?.dispose(),this.view=null}toggle(){this.clock.playing?(this.clock.pause(),this.speak(this.where())):(this.clock.play(),this.speak("plays"))}seek(e){this.call(-1),this.clock.seek(e)}nudge(e){this.seek(this.clock.time+e*this.stage.end),this.clock.playing||this.speak(this.where())}event(e){this.clock.pause(),this.call(-1);let t=this.events(),i=da(t,this.clock.time);if(e===1)this.clock.seek(i<t.length?t[i].at:this.stage.end);else{let r=i-1;for(;r>=0&&t[r].at>=this.clock.time;)r-=1;this.clock.seek(r>=0?t[r].at:0)}this.speak(this.where())}parting(e){let{partings:t,balls:i}=this.stage.data;if(t.length===0){this.speak("no collision order differs");return}this.clock.pause();let r=e??(this.called+1)%t.length,s=t[r];for(let o of s.runs)o<this.choice.shown.length&&(this.choice.shown[o]=!0);this.clock.seek(Math.fround(s.time)),this.call(r),this.choice.called=s.balls.map(o=>i.findIndex(a=>a.id===o)).filter(o=>o>=0),this.view?.close(this.around(this.choice.called)),this.changed(),this.speak(`${Oi(s.time,this.stage.end)} ${this.stage.data.scene.time_unit}: ${s.words}`)}rate(e){this.clock.rate=e}faster(e){let t=Xs.indexOf(this.clock.rate)+e;this.rate(Xs[Math.min(Xs.length-1,Math.max(0,t))]),this.speak(`speed ${this.clock.rate}`)}look(e){this.waiting?.dispose(),this.waiting=null;let t=e==="flat";t!==(this.choice.camera==="flat")&&this.swap(t?new Gr(this.stage,this.still):this.world()),this.choice.camera=this.view instanceof Gr?"flat":e,this.view?.look(this.choice),this.changed()}apart(e){this.choice.apart=e,this.changed()}trails(e){this.choice.trails=e,this.changed()}marks(e){this.choice.marks=e,this.changed()}show(e,t){this.choice.shown[e]=t,this.changed()}solid(e){this.choice.shown[e]=!0,this.choice.solid=e,this.controls.mark(this.events()),this.changed(),this.tick()}follow(e){this.choice.ball=e,this.changed()}nextCamera(){let e=this.solidView?["above","free","flat"]:["flat"];this.look(e[(e.indexOf(this.choice.camera)+1)%e.length])}still=()=>this.calm.matches;world(){try{return new Pl(this.stage,this.still,()=>this.lost())}catch{return null}}lost(){let e=this.view;if(!(e instanceof Pl))return;let{camera:t}=this.choice;e.canvas.addEventListener("webglcontextrestored",()=>{this.view instanceof Gr&&this.waiting===e&&(this.waiting=null,this.choice.camera=t,this.swap(e),this.changed())},{once:!0}),this.waiting=e,this.choice.camera="flat",this.swap(new Gr(this.stage,this.still)),this.changed(),this.speak("the graphics were lost: the table is drawn flat")}swap(e){if(!e||!this.view)return;let t=this.view;t.canvas.replaceWith(e.canvas),t!==this.waiting&&t.dispose(),this.view=e,this.resize()}events(){return this.stage.runs[this.choice.solid]?.events??[]}where(){let{clock:e,stage:t}=this,i=this.events(),r=da(i,e.time),s=[];for(let a=r-1;a>=0&&i[a].at===e.time;a-=1)s.unshift(Yl(i[a]));let o=`${Oi(e.time,t.end)} ${t.data.scene.time_unit}`;return s.length>0?`${o}, event ${r} of ${i.length}: ${s.join("; ")}`:`${o}, ${r} of ${i.length} events`}speak(e){zn(this.status,e)}call(e){this.called=e;let t=e>=0?this.stage.data.partings[e]:void 0;if(this.banner.hidden=t===void 0,t){let{data:i,end:r}=this.stage,s=t.runs.map(o=>me("span",{class:"rp-who"},Ys(o),i.runs[o]?.label??""));this.banner.replaceChildren(...s,me("b",{},`part at ${Oi(t.time,r)} ${i.scene.time_unit}. `),t.words)}else this.choice.called.length>0&&(this.choice.called=[],this.view?.close(null),this.ask());this.element.dataset.parting=String(e)}around(e){let{choice:t,frame:i}=this;i.go(this.clock.time);let r={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0};for(let s of i.scatters.filter(({run:o})=>t.shown[o.index]))for(let o of e){let[a,l]=[s.positions[3*o],s.positions[3*o+1]];r.x0=Math.min(r.x0,a),r.x1=Math.max(r.x1,a),r.y0=Math.min(r.y0,l),r.y1=Math.max(r.y1,l)}return r.x1>=r.x0&&r.y1>=r.y0?Qi(r,aw):null}tick=()=>{let{clock:e,element:t,stage:i}=this,r=this.called>=0?i.data.partings[this.called]:void 0;r&&Math.abs(e.time-r.time)>.8*e.rate*e.base&&this.call(-1),t.dataset.time=String(e.time),t.dataset.playing=String(e.playing),this.controls.tell(this.events()),this.plots.go(e.time,e.playing),this.ask(),!e.playing&&e.time>=i.end&&i.end>0&&this.speak(`the end, ${this.where()}`)};changed(){let{choice:e,stage:t}=this;this.controls.choose(e),this.legend.choose(e),this.plots.choose(e),this.element.dataset.view=e.camera,this.caption(),this.plots.go(this.clock.time,this.clock.playing),this.element.dataset.solid=t.data.runs[e.solid]?.label??"",this.ask()}caption(){let{choice:e,stage:t}=this,i=kr(e);if(this.captions.hidden=i.length<2,i.length<2)return;let{width:r,height:s}=this.picture.getBoundingClientRect(),{cells:o}=hs(t.sight,i.length,r,s);this.captions.replaceChildren(...i.map((a,l)=>{let c=me("span",{},Ys(a),t.data.runs[a].label);return c.style.left=`${o[l].x}px`,c.style.top=`${o[l].y}px`,c}))}resize(){let{stage:e,picture:t,view:i}=this,r=this.element.clientWidth;if(r<=0||!i)return;let{sight:s}=e,o=[s.x1-s.x0,s.y1-s.y0],[a,l]=[Math.max(...o),Math.min(...o)],c=r<560,u=c?r*a/l:r*l/a,h=Math.round(Math.min(Math.max(u,260),Math.max(300,(c?.56:.64)*window.innerHeight)));t.style.height=`${h}px`,i.resize(r,h),this.caption(),this.draw()}ask=()=>{this.asked===0&&(this.element.dataset.pending="true",this.asked=requestAnimationFrame(()=>{this.asked=0,this.element.dataset.pending="false",this.draw()}))};draw(){this.view&&(this.frame.go(this.clock.time),this.readout.tell(this.frame,this.choice.solid,this.clock.playing),this.element.dataset.drawn=String(this.clock.time),this.view.draw(this.frame,this.choice,this.clock.rate*this.clock.base,this.clock.playing)&&this.ask())}};function lv(){for(let n of document.querySelectorAll("script.replay-data")){let e=n.closest(".replay");if(e&&n.textContent){let{autoplay:t,growing:i,flat:r}=e.dataset;av(e,JSON.parse(n.textContent),{autoplay:t!==void 0,growing:i!==void 0,flat:r!==void 0})}}}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",lv):lv();})();

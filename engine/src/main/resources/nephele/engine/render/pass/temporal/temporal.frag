// Averages display values of successive frames, of which each has seen another point of each drawn pixel.

uniform sampler2D displayed; // a: see render.frame.FrameRequest.storesDistance
// rgb: the average. a: whole part: the weight of the frames in it, of which ALL is that of frames at all points; the rest: how
// far they are from the average.
uniform sampler2D history;
uniform vec2 pixelsOfDrawn; // of the picture, across and up
uniform vec2 shift; // of the drawn picture, drawn pixels
uniform vec3 course; // x: 1 in the first frame, y: frames since the view has last changed, z: weight of a frame that sees a pixel's centre
// Rows of the map from this frame's picture to that of the frame before: factors on the place in the picture (-1 to 1), 1,
// and 1 / distance along the view's axis.
uniform vec4 acrossBefore;
uniform vec4 upBefore;
uniform vec4 aheadBefore;

in vec2 st;

layout(location = 0) out vec4 shown;
layout(location = 1) out vec4 average;

const float IN_HAND = java(render.pass.temporal.TemporalPass.IN_HAND);
const float REACH = java(render.pass.temporal.TemporalPass.REACH_PIXELS);
const float ALL = java(render.pass.temporal.TemporalPass.ALL_POINTS);
// Weights of an average, in those of frames at all points; while the view moves it has at most one.
const float MOST_AT_REST = 2.0;
const float LEFT_OF_MOTION = 0.5; // when the view comes to rest
const float SLACK = 0.25;
const float POINTS = java(render.resource.PictureHistory.POINTS);
const float FIRST_TRUSTED = 4.0; // frame at rest: in those before, the average may still be of something that has gone
const float SETTLED = 32.0; // frames at rest
const float CODE_VALUE = 1.0 / 255.0;
const float REJECTED = 32.0 * CODE_VALUE; // so far from what the frame shows, the average is of something else
const float MOST_SPREAD = 0.9;

float largest(vec3 v) {
    return max(max(v.r, v.g), v.b);
}

void main() {
    ivec2 last = textureSize(displayed, 0) - 1;
    vec2 place = st * vec2(last + 1) + shift;
    ivec2 at = clamp(ivec2(floor(place)), ivec2(0), last);
    vec4 here = texelFetch(displayed, at, 0);
    vec2 aside = (place - vec2(at) - 0.5) * pixelsOfDrawn;
    float fall = max(1.0 - dot(aside, aside) / (REACH * REACH), 0.0);
    float weight = fall * fall * course.z;
    if (course.x > 0.0) {
        average = vec4(texture(displayed, st).rgb, floor(weight + 0.5));
        shown = vec4(average.rgb, 1.0);
        return;
    }
    ivec2 low = max(at - 1, ivec2(0));
    ivec2 high = min(at + 1, last);
    vec4 left = texelFetch(displayed, ivec2(low.x, at.y), 0);
    vec4 right = texelFetch(displayed, ivec2(high.x, at.y), 0);
    vec4 below = texelFetch(displayed, ivec2(at.x, low.y), 0);
    vec4 above = texelFetch(displayed, ivec2(at.x, high.y), 0);
    vec3 least = min(min(min(left.rgb, right.rgb), min(below.rgb, above.rgb)), here.rgb);
    vec3 most = max(max(max(left.rgb, right.rgb), max(below.rgb, above.rgb)), here.rgb);

    vec4 before;
    float known; // weight of the average
    float spread = 0.0;
    if (course.y > 0.0) {
        before = texelFetch(history, ivec2(gl_FragCoord.xy), 0);
        known = min(floor(before.a), ALL * (course.y < 1.5 ? LEFT_OF_MOTION : MOST_AT_REST));
        spread = before.a - floor(before.a);
#ifdef DISTANCE_STORED
        float moving = min(min(min(left.a, right.a), min(below.a, above.a)), here.a);
        spread = moving < 0.0 ? 0.0 : spread;
#endif
        float margin = 1.25 * spread + 0.5 * CODE_VALUE; // of which the stored number loses up to a sixteenth
        least -= margin;
        most += margin;
    } else {
#ifdef DISTANCE_STORED
        float nearness = max(max(max(abs(left.a), abs(right.a)), max(abs(below.a), abs(above.a))), abs(here.a));
#else
        float nearness = 0.0;
#endif
        vec4 seen = vec4(2.0 * st - 1.0, 1.0, nearness);
        vec3 was = vec3(dot(acrossBefore, seen), dot(upBefore, seen), dot(aheadBefore, seen));
        bool isInHand = here.a < 0.5 * IN_HAND;
        vec2 stBefore = isInHand ? st : 0.5 * was.xy / was.z + 0.5;
        before = texture(history, stBefore);
        bool isSeen = (isInHand || was.z > 0.0) && all(greaterThanEqual(stBefore, vec2(0.0))) && all(lessThanEqual(stBefore, vec2(1.0)));
        known = isSeen ? min(floor(before.a), ALL) : 0.0;
    }
    float outside = largest(max(max(least - before.rgb, before.rgb - most), 0.0));
    known *= 1.0 - min(outside / REJECTED, 1.0);
    // Frames that have seen all points since the view came to rest, or else many frames: more would only change the weights.
    bool isComplete = course.y >= POINTS - 1.0 && outside <= 0.0 && known >= ALL * (1.0 - SLACK)
            && (known <= ALL * (1.0 + SLACK) || course.y >= SETTLED);
    vec3 kept = clamp(before.rgb, least, most);
    vec3 mean = mix(kept, here.rgb, weight / max(known + weight, 1e-3));
    spread = course.y >= FIRST_TRUSTED ? clamp(largest(abs(here.rgb - mean)), spread, MOST_SPREAD) : 0.0;
    average = isComplete ? before : vec4(known == 0.0 ? here.rgb : mean, floor(known + weight + 0.5) + spread);
    shown = vec4(average.rgb, 1.0);
}

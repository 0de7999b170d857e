// The corner of a billboard's image in the world. The twins are level.billboard.FacingAxes and Sway; the numbers come from
// render.resource.BillboardQuads and BillboardList.

layout(location = 0) in vec2 corner; // -1 to 1

// Two texels an image: foot, metres from the anchor, and group; share of the size, random number, share of the sky that is
// seen, and turn of crossed ones, radians.
uniform samplerBuffer billboards;
// Five texels a group, see billboardGroup.
uniform samplerBuffer billboardGroups;
uniform samplerBuffer billboardOrder; // four images in each texel, -1 for none

const int SPHERICAL = java(level.Billboards.Facing.SPHERICAL);
const int CYLINDRICAL = java(level.Billboards.Facing.CYLINDRICAL);
const int SCREEN = java(level.Billboards.Facing.SCREEN);
const int CROSSED = java(level.Billboards.Facing.CROSSED);

const float TURN = 6.2831853;
const float STEEP = java(level.billboard.FacingAxes.STEEP);

struct Billboard {
    vec3 foot;
    int group;
    float scale;
    float random;
    float sky;
    float turn;
};

// Returns the number of the image that this vertex belongs to; -1 for none.
int billboardNumber() {
    int place = gl_InstanceID * PER_SHEET + gl_VertexID / VERTICES;
    return int(texelFetch(billboardOrder, place / 4)[place % 4]);
}

Billboard billboardAt(int number) {
    vec4 place = texelFetch(billboards, 2 * number);
    vec4 look = texelFetch(billboards, 2 * number + 1);
    return Billboard(place.xyz, int(place.w), look.x, look.y, look.z, look.w);
}

// 0: width, height, facing, first layer; 1: frame, frames, whether they move; 2: lean, swing, its turns and its turns a
// metre; 3: the one colour, if w is 1; 4: emission.
vec4 billboardGroup(int group, int texel) {
    return texelFetch(billboardGroups, 5 * group + texel);
}

// Returns the horizontal direction to the right of one who looks at the billboard.
vec3 levelRight(vec3 toEye, vec3 side) {
    float level = dot(toEye.xz, toEye.xz);
    if (level > STEEP * (level + toEye.y * toEye.y)) {
        return vec3(toEye.z, 0.0, -toEye.x) * inversesqrt(level);
    }
    float length2 = dot(side.xz, side.xz);
    return length2 > 1e-12 ? vec3(side.x, 0.0, side.z) * inversesqrt(length2) : vec3(1.0, 0.0, 0.0);
}

struct BillboardAxes {
    vec3 right;
    vec3 up;
};

// toEye: from the middle, any length; side, above: unit axes of the view
BillboardAxes facingAxes(int facing, vec3 toEye, vec3 side, vec3 above, float turn) {
    if (facing == SCREEN) {
        return BillboardAxes(side, above);
    }
    if (facing == SPHERICAL) {
        vec3 right = levelRight(toEye, side);
        float metres = length(toEye);
        vec3 up = metres > 0.0 ? normalize(cross(toEye / metres, right)) : vec3(0.0, 1.0, 0.0);
        return BillboardAxes(right, up);
    }
    if (facing == CYLINDRICAL) {
        return BillboardAxes(levelRight(toEye, side), vec3(0.0, 1.0, 0.0));
    }
    float angle = turn;
    if (facing != CROSSED) {
        // The monograph's formula, which faces away where toEye.z is negative.
        angle = toEye.x == 0.0 ? 0.0 : toEye.z == 0.0 ? sign(toEye.x) * TURN / 4.0 : atan(toEye.x / toEye.z);
    }
    return BillboardAxes(vec3(cos(angle), 0.0, -sin(angle)), vec3(0.0, 1.0, 0.0));
}

// Returns the axes towards an observer who has no picture: those parallel to it turn about their middle.
BillboardAxes observedAxes(int facing, vec3 toObserver, float turn) {
    int faced = facing == SCREEN ? SPHERICAL : facing;
    return facingAxes(faced, toObserver, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), turn);
}

// Returns the metres by which the upper edge is moved towards +x.
float swayMetres(vec4 wind, Billboard b, float height) {
    if (wind.x == 0.0) {
        return 0.0;
    }
    float turns = wind.z - b.foot.x * wind.w + 0.25 * b.random;
    return height * wind.x * (1.0 + wind.y * sin(TURN * fract(turns)));
}

// Returns the corner from the middle.
vec3 cornerFromMiddle(BillboardAxes axes, vec2 size, float sway) {
    vec3 at = axes.right * (0.5 * corner.x * size.x) + axes.up * (0.5 * corner.y * size.y);
    at.x += corner.y > 0.0 ? sway : 0.0;
    return at;
}

// Returns the layer of the picture, with the share of the next frame as fraction, in [0, frames).
float billboardFrame(vec4 frames, Billboard b) {
    float from = frames.x + b.random * frames.y;
    from = frames.z > 0.0 ? from : floor(from);
    return mod(from, frames.y);
}

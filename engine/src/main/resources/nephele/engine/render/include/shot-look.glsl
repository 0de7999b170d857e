// The opacity of a shot's light; twin: scene.ShotLook of the tests.

const float BOLT_FLIGHT = java(scene.FrameState.ShotEffect.BOLT_FLIGHT);
const float BOLT_TAIL = java(scene.FrameState.ShotEffect.BOLT_TAIL);

// along: share of the way, across: -1 to 1, age: share of the time
float boltOpacity(float along, float across, float age) {
    float head = min(age / BOLT_FLIGHT, 1.0);
    float behind = (head - along) / BOLT_TAIL;
    if (behind < 0.0) {
        return 0.0;
    }
    float after = clamp((age - BOLT_FLIGHT) / (1.0 - BOLT_FLIGHT), 0.0, 1.0);
    float tail = clamp(1.0 - behind * (1.0 + after), 0.0, 1.0);
    float narrow = 1.0 - across * across;
    return narrow * narrow * tail * (1.0 - after) * (1.0 - after);
}

// radius: 0 in the middle to 1, age: share of the time
float shimmerOpacity(float radius, float age) {
    if (radius >= 1.0) {
        return 0.0;
    }
    float front = sqrt(age);
    float behind = (front - radius) * 3.0;
    float ring = behind < 0.0 ? max(0.0, 1.0 + 6.0 * behind) : 0.5 + 0.5 * cos(6.2831853 * behind);
    float fade = (1.0 - age) * (1.0 - radius * radius);
    return ring * fade / (1.0 + 0.6 * max(behind, 0.0));
}

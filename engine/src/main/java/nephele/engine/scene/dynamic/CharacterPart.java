package nephele.engine.scene.dynamic;

import nephele.engine.math.Vec3;

/**
 * The rigid parts of the player's character, each with the half sides in metres of its bounding box about its origin;
 * the head is the last.
 */
enum CharacterPart {
    PELVIS(0.19, 0.31, 0.17),
    CHEST(0.24, 0.28, 0.27),
    LEFT_UPPER_ARM(0.10, 0.22, 0.10),
    RIGHT_UPPER_ARM(0.10, 0.22, 0.10),
    LEFT_FOREARM(0.09, 0.26, 0.10),
    RIGHT_FOREARM(0.09, 0.26, 0.10),
    LEFT_THIGH(0.12, 0.31, 0.13),
    RIGHT_THIGH(0.12, 0.31, 0.13),
    LEFT_SHIN(0.10, 0.28, 0.11),
    RIGHT_SHIN(0.10, 0.28, 0.11),
    LEFT_FOOT(0.08, 0.13, 0.20),
    RIGHT_FOOT(0.08, 0.13, 0.20),
    HEAD(0.19, 0.21, 0.20);

    static final CharacterPart[] ALL = values();

    private final DynamicShape shape;

    CharacterPart(double halfX, double halfY, double halfZ) {
        shape = new DynamicShape(DynamicShape.PART, new Vec3(halfX, halfY, halfZ), 0);
    }

    DynamicShape shape() {
        return shape;
    }

    boolean isLeft() {
        return name().startsWith("LEFT");
    }
}

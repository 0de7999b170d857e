package nephele.engine.level;

/** The meaning of a written number or vector in the world: how moving, turning and scaling its record change it. */
public enum Spatial {
    /** A colour, an angle, a mass and everything else that a change of place leaves as it is. */
    NONE,
    /** A point in the world, in metres. */
    POINT,
    /** A direction in the world; its length has no meaning. */
    DIRECTION,
    /** The sides of a box along the axes of the world, in metres. */
    EXTENT,
    /** A length, in metres. */
    LENGTH
}

package nephele.engine.collision;

/** Points relative to an origin, which stand for their convex hull. */
interface SupportPoints {
    /** Returns the index of the point farthest along a direction. */
    int farthest(double x, double y, double z);

    /** Returns one coordinate of a point, relative to the origin. */
    double vertex(int point, int axis);
}

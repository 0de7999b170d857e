package nephele.engine.collision;

/** Points around a place whose convex hull is meant. */
interface ConvexPoints {
    /** The point that lies farthest along a direction. */
    int farthest(double x, double y, double z);

    /** One coordinate of a point, relative to the place. */
    double vertex(int point, int axis);
}

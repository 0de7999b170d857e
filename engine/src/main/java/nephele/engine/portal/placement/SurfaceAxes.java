package nephele.engine.portal.placement;

import nephele.engine.math.Vec3;

/** Turns a direction on a surface to the nearest right angle of one of the surface's edges. */
final class SurfaceAxes {
    private SurfaceAxes() {}

    /**
     * Returns the direction along or across the edge that differs least from another one: of the region's outline, or of
     * what stands on it.
     *
     * @param direction of unit length, in the region's plane
     * @param leastMetres least length of an edge that counts
     * @param mostRadians greatest difference; beyond, the direction itself is returned
     */
    static Vec3 nearest(Region region, Vec3 direction, double leastMetres, double mostRadians) {
        PlaneFrame frame = region.frame();
        double x = frame.xOf(direction);
        double y = frame.yOf(direction);
        double[] turn = {StrictMath.tan(mostRadians), Double.NaN, Double.NaN};
        offer(region.outline(), x, y, leastMetres, turn);
        offer(region.bars(), x, y, leastMetres, turn);
        return Double.isNaN(turn[1]) ? direction : frame.worldDirection(turn[1], turn[2]);
    }

    /** @param turn the least tangent so far, and the direction that has it */
    private static void offer(PolygonIndex shapes, double x, double y, double leastMetres, double[] turn) {
        for (int i = 0; i < shapes.size(); i++) {
            ConvexPolygon shape = shapes.shape(i);
            for (int edge = 0; edge < shape.corners(); edge++) {
                if (shape.length(edge) >= leastMetres) {
                    offer(shape.normalX(edge), shape.normalY(edge), x, y, turn);
                }
            }
        }
    }

    private static void offer(double acrossX, double acrossY, double x, double y, double[] turn) {
        double across = acrossX * x + acrossY * y;
        double along = acrossX * y - acrossY * x;
        boolean isAcross = Math.abs(across) >= Math.abs(along);
        double tangent = Math.abs(isAcross ? along / across : across / along);
        if (tangent < turn[0]) {
            double sense = Math.signum(isAcross ? across : along);
            turn[0] = tangent;
            turn[1] = sense * (isAcross ? acrossX : -acrossY);
            turn[2] = sense * (isAcross ? acrossY : acrossX);
        }
    }
}

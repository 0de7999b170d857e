package nephele.engine.render.resource;

import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.Occluders;

/** The fraction of the sky that is visible from billboards: rays from the middle of each, weighted as a level surface receives light. */
final class BillboardSky {
    private static final int RAYS = 24;
    private static final int FEW_RAYS = 8;
    /** More billboards than these have few rays each, so that a forest is ready as soon as a garden. */
    private static final int MANY = 20_000;

    /** {@code null} if all of the sky is seen, or none matters. */
    private final Occluders occluders;

    private final double[][] directions;
    private final double[] from = new double[3];

    BillboardSky(StaticShapes statics, boolean isSkyLit, int billboards) {
        boolean isHidden = isSkyLit && statics.all().size() > 1;
        occluders = isHidden ? new Occluders(statics) : null;
        directions = new double[billboards > MANY ? FEW_RAYS : RAYS][];
        for (int i = 0; i < directions.length; i++) {
            double square = (i + 0.5) / directions.length;
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            double flat = Math.sqrt(square);
            directions[i] = new double[] {flat * Math.cos(angle), Math.sqrt(1 - square), flat * Math.sin(angle)};
        }
    }

    float visibleFrom(Vec3 middle) {
        if (occluders == null) {
            return 1;
        }
        from[0] = middle.x();
        from[1] = middle.y();
        from[2] = middle.z();
        int open = 0;
        for (double[] direction : directions) {
            open += occluders.isOccluded(from, direction, -1) ? 0 : 1;
        }
        return (float) open / directions.length;
    }
}

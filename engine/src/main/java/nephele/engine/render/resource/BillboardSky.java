package nephele.engine.render.resource;

import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.Occluders;
import nephele.engine.scene.probe.LitSurfaces;

/**
 * The light around billboards, by rays from the middle of each: the fraction of the sky that is visible, weighted as a
 * level surface receives light, and where light was baked the mean radiance of the static geometry.
 */
final class BillboardSky {
    private static final int RAYS = 24;
    private static final int FEW_RAYS = 8;
    /** More billboards than these have few rays each, so that a forest is ready as soon as a garden. */
    private static final int MANY = 20_000;

    /** {@code null} if all of the sky is seen, or none matters. */
    private final Occluders occluders;

    private final double[][] directions;
    private final double[] from = new double[3];

    /** {@code null} without baked light. */
    private final LitSurfaces surfaces;

    /** A texel for each billboard. */
    private final float[] bounced;

    /** @param statics what hides the sky */
    BillboardSky(LoadContext context, StaticShapes statics, int billboards) {
        Scene scene = context.scene();
        surfaces = LightRequirements.bounces(scene.light()) ? AmbientLight.surfaces(context) : null;
        bounced = new float[surfaces == null ? 0 : 4 * billboards];
        boolean isHidden =
                LightRequirements.skyShines(scene.level()) && statics.all().size() > 1;
        occluders = isHidden ? new Occluders(statics) : null;
        directions = new double[billboards > MANY ? FEW_RAYS : RAYS][];
        for (int i = 0; i < directions.length; i++) {
            double square = (i + 0.5) / directions.length;
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            double flat = Math.sqrt(square);
            directions[i] = new double[] {flat * Math.cos(angle), Math.sqrt(1 - square), flat * Math.sin(angle)};
        }
    }

    /** Finds the light at a billboard, and returns the visible fraction of the sky. */
    float find(int billboard, Vec3 middle) {
        if (surfaces != null) {
            surfaces.around(middle, 2 * directions.length, bounced, 4 * billboard);
        }
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

    /** Returns a texture with the light that surfaces send to each billboard, {@code null} without baked light. */
    BufferTexture bounced(GlContext gl) {
        return bounced.length == 0 ? null : BufferTexture.ofFloats(gl, "bounced light", bounced);
    }
}

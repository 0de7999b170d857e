package nephele.engine.render.resource;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.scene.light.LightRequirements;

/**
 * What the billboards on the GPU follow from; equal values make equal ones.
 *
 * @param kind those that are made of the level's
 * @param anchor world position from which places are measured
 * @param format of their pictures
 * @param keepsCoverage whether smaller mipmap levels of those with edges keep the share that is drawn
 */
public record BillboardSource(
        Same billboards,
        Same solids,
        Same models,
        Same assets,
        boolean isSkyLit,
        Kind kind,
        Vec3 anchor,
        PixelFormat format,
        boolean keepsCoverage) {
    /** How billboards are drawn. */
    public enum Kind {
        /** Where they cover half or more; they write depth and cast shadows. */
        WITH_EDGES,
        /** Over what is behind them, the farthest first. */
        BLENDED
    }

    public static BillboardSource of(
            Level level,
            StaticShapes statics,
            AssetSource assets,
            Kind kind,
            Vec3 anchor,
            PixelFormat format,
            boolean keepsCoverage) {
        return new BillboardSource(
                new Same(level.billboards()),
                new Same(statics.solids()),
                new Same(statics.models()),
                new Same(assets),
                LightRequirements.skyShines(level),
                kind,
                anchor,
                format,
                keepsCoverage && kind == Kind.WITH_EDGES);
    }
}

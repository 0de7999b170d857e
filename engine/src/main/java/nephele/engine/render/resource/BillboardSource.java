package nephele.engine.render.resource;

import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.SharedObjects.Identity;
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
        Identity billboards,
        Identity solids,
        Identity models,
        Identity assets,
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
                new Identity(level.billboards()),
                new Identity(statics.solids()),
                new Identity(statics.models()),
                new Identity(assets),
                LightRequirements.skyShines(level),
                kind,
                anchor,
                format,
                keepsCoverage && kind == Kind.WITH_EDGES);
    }
}

package nephele.engine.reference;

import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/** Traces pictures of test levels. */
final class Traced {
    private Traced() {}

    static float[] picture(TestLevel level, Pinhole eye, TraceSettings settings) {
        return picture(level, TestAssets.NONE, eye, settings);
    }

    static float[] picture(TestLevel level, AssetSource assets, Pinhole eye, TraceSettings settings) {
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level.level(), assets), ColourDecoding.SRGB);
        return ReferencePicture.trace(traced, eye, settings, done -> {});
    }

    /** Returns the single pixel of a picture of nearly zero size. */
    static float[] towards(TestLevel level, Vec3 from, Vec3 to, int samples) {
        return picture(level, eye(from, to, 1e-7), new TraceSettings(1, 1, samples, 1, 1));
    }

    static Pinhole eye(Vec3 from, Vec3 to, double halfWidth) {
        Basis basis = Basis.lookAt(from, to, new Vec3(0, 1, 0), Basis.WORLD);
        return new Pinhole(from, basis, halfWidth, halfWidth, 0.05, 1e4);
    }
}

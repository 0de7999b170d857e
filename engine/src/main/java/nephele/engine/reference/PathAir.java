package nephele.engine.reference;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.atmosphere.AirLight;
import nephele.engine.level.appearance.AirOfEnvironment;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The effect of air and mirrors on the light along a path: each straight part has the air of the altitude at which it
 * begins, so that a path through portals passes the air of every place on it.
 *
 * @param added radiance that arrives at the path's beginning without any behind its end
 * @param passed fraction of the radiance behind its end that arrives at its beginning
 */
record PathAir(Vector3d added, Vector3d passed) {
    /**
     * Returns a random effect of the right mean.
     *
     * @param parts of the path in order; the air before the end of an endless one belongs to the sky's radiance
     */
    static PathAir of(
            Optional<AirOfEnvironment> air,
            Optional<AirShade> shade,
            List<EyePath.Segment> parts,
            SplittableRandom random) {
        PathAir sum = new PathAir(new Vector3d(), new Vector3d(1));
        if (air.isPresent()) {
            for (EyePath.Segment part : parts) {
                sum.add(air.get(), shade, part, random);
            }
        }
        sum.passed.mul(parts.get(parts.size() - 1).tint());
        return sum;
    }

    private void add(AirOfEnvironment air, Optional<AirShade> shade, EyePath.Segment part, SplittableRandom random) {
        double metres = part.metres();
        Vec3 direction = part.direction();
        Vector3d before = new Vector3d(passed).mul(part.tint());
        Vector3d light = new Vector3d();
        if (metres < Double.POSITIVE_INFINITY) {
            AirLight between = air.between(part.origin(), direction, metres);
            light.set(between.radiance().toVector());
            passed.mul(between.transmittance().toVector());
        }
        shade.ifPresent(all -> light.sub(all.taken(part.origin(), direction, metres, random)));
        added.add(light.mul(before));
    }
}

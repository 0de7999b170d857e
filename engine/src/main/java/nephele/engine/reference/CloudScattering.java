package nephele.engine.reference;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.DistantLight;
import nephele.engine.reference.volume.Surroundings;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The light of sun, moon and lamps that clouds scatter towards a path, shaded by walls and clouds. Near a lamp its light
 * is found on the path before a collision, at {@link LampDistances}; else at the collision. How much each of both counts
 * depends on the place alone, so their sum has the right mean. Use one per thread.
 */
final class CloudScattering {
    private final CloudMedia media;
    private final Surroundings around;
    private final List<PunctualLight> lamps;
    /** The phase function of the cloud around each lamp; isotropic for a lamp in no cloud. */
    private final Map<PunctualLight, PhaseFunction> phases = new HashMap<>();

    /** @param around walls and portals that stop straight light, and the light from outside */
    CloudScattering(CloudMedia media, Surroundings around, List<PunctualLight> lamps) {
        this.media = media;
        this.around = around;
        this.lamps = lamps;
        for (PunctualLight lamp : lamps) {
            phases.put(lamp, new HenyeyGreenstein(0));
            media.at(lamp.position()).forEach(medium -> phases.put(lamp, medium.phase()));
        }
    }

    /** The fraction of light that arrives from a place on a part of a path, for each channel. */
    @FunctionalInterface
    interface Attenuation {
        /** @param metres from the part's beginning */
        Vector3dc of(EyePath.Segment part, double metres);
    }

    /** Returns sun and moon. */
    List<DistantLight> distantLights() {
        return around.lights();
    }

    /** Returns the sky's radiance for a path that leaves a cloud. */
    Vector3d skylight(EyePath.Segment last) {
        return around.skylight(last.origin(), last.direction()).toVector();
    }

    /** Returns true if straight light between a place in a cloud and one at a distance is stopped. */
    boolean isBlocked(Vector3dc from, Vector3dc direction, double metres) {
        return around.isPathBlocked(TracedItems.ray(from, direction), metres);
    }

    /** Returns a random radiance towards the eye whose mean, with {@link #lampsAlong}, is that by sun, moon and lamps. */
    Vector3d direct(PathVertex.InCloud at, SplittableRandom random) {
        Vector3d sum = new Vector3d();
        for (DistantLight light : around.lights()) {
            Ray ray = Ray.of(at.place(), light.towards());
            Vector3d irradiance = light.irradiance(at.place()).toVector();
            if (isLight(irradiance) && !around.isLightBlocked(ray)) {
                double passed = media.transmittance(ray, 0, around.reachMetres(ray), random);
                sum.add(at.reflected(light.towards().toVector()).mul(irradiance).mul(passed));
            }
        }
        for (PunctualLight lamp : lamps) {
            sum.add(scattered(lamp, at, random).mul(1 - nearness(lamp, at)));
        }
        return sum;
    }

    /** Returns the weight of a lamp's light that is found on the path: near 1 where it is nearer than a free path. */
    private static double nearness(PunctualLight lamp, PathVertex.InCloud at) {
        double depth = perMetre(at) * at.place().minus(lamp.position()).length();
        return 1 / (1 + depth * depth);
    }

    private static double perMetre(PathVertex.InCloud at) {
        Vec3 place = at.place();
        return at.medium().field().perMetre(place.x(), place.y(), place.z());
    }

    private Vector3d scattered(PunctualLight lamp, PathVertex.InCloud at, SplittableRandom random) {
        Vector3d towards = lamp.position().minus(at.place()).toVector();
        double metres = towards.length();
        Vector3d irradiance = lamp.irradianceAt(at.place());
        if (metres == 0 || !isLight(irradiance)) {
            return new Vector3d();
        }
        Ray ray = TracedItems.ray(at.rayOrigin(), towards.div(metres));
        if (lamp.source().castsShadow() && around.isPathBlocked(ray, metres)) {
            return new Vector3d();
        }
        return at.reflected(towards).mul(irradiance).mul(media.transmittance(ray, 0, metres, random));
    }

    private static boolean isLight(Vector3dc rgb) {
        return rgb.x() + rgb.y() + rgb.z() > 0;
    }

    /**
     * Returns a random radiance whose mean is what clouds scatter on a path of the light of near lamps.
     *
     * @param parts of a path to its first collision or its end
     */
    Vector3d lampsAlong(List<EyePath.Segment> parts, Attenuation before, SplittableRandom random) {
        Vector3d sum = new Vector3d();
        for (PunctualLight lamp : lamps) {
            for (EyePath.Segment part : parts) {
                addAlong(part, lamp, before, random, sum);
            }
        }
        return sum;
    }

    /** Adds the light of a lamp at one random place of a part of a path. */
    private void addAlong(
            EyePath.Segment part, PunctualLight lamp, Attenuation before, SplittableRandom random, Vector3d sum) {
        LampDistances distances = new LampDistances(part, lamp, phases.get(lamp));
        if (distances.isEmpty()) {
            return;
        }
        distances.choose(random);
        double metres = distances.metres();
        Vec3 place = part.origin().addScaled(metres, part.direction());
        for (CloudMedium medium : media.at(place)) {
            var at = new PathVertex.InCloud(place, part.direction(), medium);
            Vector3d light = scattered(lamp, at, random);
            if (isLight(light)) {
                light.mul(nearness(lamp, at) * perMetre(at) / distances.perMetre());
                sum.add(light.mul(before.of(part, metres)));
            }
        }
    }
}

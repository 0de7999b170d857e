package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * Marches a ray through a cloud's cells, the twin of {@code cloud-march.glsl}. Each step is integrated exactly for a constant
 * source, so that a cloud in even light neither gains nor loses energy at any number of steps. Not for several threads.
 */
public final class CellMarch {
    /** The march ends when so little of the diffuse light behind is left; what is behind is then taken as the last. */
    private static final double OPAQUE = 0.01;

    /** Metres of a step per metre of distance. */
    private static final double GROWTH = 0.01;

    /** Part of a box's reach, as a logarithm, in which the next one takes over. */
    private static final double FADING = 0.25;

    private final CellStack cloud;
    private final OutsideOfCloud outside;
    private final List<CellPlace> dense;
    private final List<CellPlace> lit;
    private final double focusX;
    private final double focusZ;
    /** The box that serves the last place, and the weight of the next wider one. */
    private int level;

    private double next;
    private final Vec3 diffuseAxis;
    private final ExtinctionField exact;
    private final double[] light = new double[LightCells.VALUES];
    private double transmittance;
    private double eyeDepth;
    private double depthAround;
    private double exitLight;
    private double scaledTransmittance;
    private double sunlight;
    private double above;
    private double below;
    private double covered;
    private int fetches;
    private double lastDiffuse;

    /**
     * The light around a cloud.
     *
     * @param towardsSun unit
     * @param irradiance of the sun
     * @param above mean radiance of the upper half of the sky, {@code below} of the lower one
     */
    public record OutsideOfCloud(Vec3 towardsSun, Vec3 irradiance, Vec3 above, Vec3 below) {
        /** Returns the greatest difference: radians of the sun's direction, and fractions of all light. */
        public double difference(OutsideOfCloud other) {
            if (other == this) {
                return 0;
            }
            double turn = Math.atan2(towardsSun.cross(other.towardsSun).length(), towardsSun.dot(other.towardsSun));
            double light = irradiance.length() + above.length() + below.length();
            double changed = irradiance.minus(other.irradiance).length()
                    + above.minus(other.above).length()
                    + below.minus(other.below).length();
            return Math.max(turn, changed / Math.max(1e-12, light));
        }
    }

    /** Creates a march whose focus is in the middle of the narrowest box. */
    public CellMarch(CellStack cloud, OutsideOfCloud outside) {
        this(cloud, outside, cloud.narrowest().box().centre());
    }

    /** @param focus of a layer's boxes; its y does not count */
    public CellMarch(CellStack cloud, OutsideOfCloud outside, Vec3 focus) {
        this(cloud, outside, focus, null);
    }

    /** @param exact takes the place of the cells' density; {@code null} for the cells' */
    public CellMarch(CellStack cloud, OutsideOfCloud outside, Vec3 focus, ExtinctionField exact) {
        this.cloud = cloud;
        this.outside = outside;
        this.exact = exact;
        dense = cloud.density().stream()
                .map(cells -> new CellPlace(cells.cells()))
                .toList();
        lit = cloud.light().stream().map(cells -> new CellPlace(cells.cells())).toList();
        focusX = focus.x();
        focusZ = focus.z();
        diffuseAxis = cloud.diffuseAxis(outside.towardsSun());
    }

    /**
     * Marches a ray of unit direction.
     *
     * @param stepCells length of a step near the eye, in shortest edges of the narrowest cells
     * @param offset place of the first sample in its step, 0 to 1
     */
    public void march(Ray ray, double fromMetres, double toMetres, double stepCells, double offset) {
        transmittance = 1;
        scaledTransmittance = 1;
        eyeDepth = 0;
        depthAround = cloud.leastDepth(new Vec3(
                ray.originX() + fromMetres * ray.directionX(),
                ray.originY() + fromMetres * ray.directionY(),
                ray.originZ() + fromMetres * ray.directionZ()));
        exitLight = Double.NaN;
        sunlight = 0;
        above = 0;
        below = 0;
        covered = 0;
        fetches = 0;
        StackSpan inside = span(ray);
        double start = Math.max(fromMetres, inside.fromMetres());
        double end = Math.min(toMetres, inside.toMetres());
        double turned = 2 - 2 * dot(ray, outside.towardsSun());
        double at = start;
        double fraction = offset;
        while (at < end && scaledTransmittance > OPAQUE) {
            double step = stepCells * Math.max(cloud.narrowest().shortest(), GROWTH * at);
            // The first step is cut, so that samples of other offsets lie between.
            double to = Math.min(at + fraction * step, end);
            step(ray, at, to, turned);
            at = to;
            fraction = 1;
        }
        finish();
    }

    private void step(Ray ray, double from, double to, double turned) {
        double middle = (from + to) / 2;
        double depth = perMetre(ray, middle) * (to - from);
        if (!(depth > 0)) {
            return;
        }
        double mean = meanDepth(depth);
        findLight(ray, from + mean / depth * (to - from));
        double sunDepth = light[0];
        CloudLight physics = cloud.physics();
        CloudOptics optics = physics.optics();
        DeltaScaling medium = physics.medium();
        double scale = medium.depthFactor();
        double taken = -Math.expm1(-depth);
        double scaledTaken = -Math.expm1(-scale * depth);
        double cosine = 1 - turned / 2;
        double alongAxis = -dot(ray, diffuseAxis);
        double beam = Math.exp(-scale * sunDepth);
        if (transmittance == 1) {
            exitLight = beam;
        }
        double narrow = physics.smallAngles().at(turned, sunDepth + eyeDepth + mean) * taken * Math.exp(mean);
        double greatest = physics.greatestMean(sunDepth, depthAround + eyeDepth + mean, exitLight);
        double kept = light[1] > greatest ? greatest / light[1] : 1;
        double alongBeam = Math.max(-light[1], Math.min(light[1], physics.slopeOfBeam() * beam));
        double slope = cosine * alongBeam + alongAxis * light[2];
        double diffuse = (1 + 3 * medium.g() * cosine) / (4 * Math.PI) * beam
                + kept * Math.max(0, light[1] + medium.g() * slope);
        lastDiffuse = medium.albedo() * diffuse;
        sunlight += narrow + scaledTransmittance * scaledTaken * lastDiffuse;
        double even = transmittance * taken * optics.albedo();
        above += even * light[3];
        below += even * light[4];
        eyeDepth += depth;
        covered += transmittance * taken;
        transmittance *= 1 - taken;
        scaledTransmittance *= 1 - scaledTaken;
    }

    private double perMetre(Ray ray, double at) {
        fetches++;
        if (exact != null) {
            return exact.perMetre(
                    ray.originX() + at * ray.directionX(), height(ray, at), ray.originZ() + at * ray.directionZ());
        }
        findBox(ray, at);
        double density = density(level, ray, at);
        if (next > 0) {
            density += next * (density(level + 1, ray, at) - density);
        }
        return density * cloud.greatestPerMetre();
    }

    private double density(int level, Ray ray, double at) {
        CellPlace place = dense.get(level);
        place(place, ray, at);
        return place.of(cloud.density().get(level).densities(), 1, 0);
    }

    private void findLight(Ray ray, double at) {
        findBox(ray, at);
        findLight(level, ray, at, 1);
        if (next > 0) {
            findLight(level + 1, ray, at, next);
        }
    }

    /** Mixes the light of a box into what has been found. */
    private void findLight(int level, Ray ray, double at, double fraction) {
        CellPlace place = lit.get(level);
        place(place, ray, at);
        for (int value = 0; value < LightCells.VALUES; value++) {
            double found = place.of(cloud.light().get(level).values(), LightCells.VALUES, value);
            light[value] = fraction == 1 ? found : light[value] + fraction * (found - light[value]);
        }
    }

    /** Finds the box of a place, as {@code boxOf} in {@code cell-boxes.glsl} does. */
    private void findBox(Ray ray, double at) {
        double atX = ray.originX() + at * ray.directionX();
        double atZ = ray.originZ() + at * ray.directionZ();
        double wide = Math.max(1e-6, Math.max(Math.abs(atX - focusX), Math.abs(atZ - focusZ)) / cloud.reachMetres());
        double widenings = Math.log(wide) / Math.log(CellStack.WIDENING);
        level = Math.min(cloud.levels() - 1, (int) Math.ceil(Math.max(0, widenings) - 1e-6));
        double fade = (widenings - level + FADING) / FADING;
        next = level + 1 < cloud.levels() ? Math.max(0, Math.min(1, fade)) : 0;
    }

    /** Returns the part of a ray that the boxes serve. */
    private StackSpan span(Ray ray) {
        Aabb box = cloud.narrowest().box();
        if (!cloud.isLayer()) {
            return StackSpan.of(box, cloud.planetRadiusMetres(), ray);
        }
        double reach = cloud.reachMetres() * Math.pow(CellStack.WIDENING, cloud.levels() - 1);
        var served = new Aabb(focusX - reach, box.minY(), focusZ - reach, focusX + reach, box.maxY(), focusZ + reach);
        return StackSpan.of(served, cloud.planetRadiusMetres(), ray);
    }

    /** Fills up what the early end has left. */
    private void finish() {
        if (scaledTransmittance <= OPAQUE) {
            sunlight += scaledTransmittance * lastDiffuse;
            above /= covered;
            below /= covered;
            transmittance = 0;
        }
        sunlight = Math.max(0, sunlight);
    }

    /** Returns the mean optical depth at which light that a step takes is taken. */
    private static double meanDepth(double depth) {
        if (depth < 1e-3) {
            return depth * (0.5 - depth / 12);
        }
        double left = Math.exp(-depth);
        return 1 - depth * left / (1 - left);
    }

    private void place(CellPlace place, Ray ray, double at) {
        place.at(ray.originX() + at * ray.directionX(), height(ray, at), ray.originZ() + at * ray.directionZ());
    }

    private double height(Ray ray, double at) {
        return StackSpan.height(cloud.planetRadiusMetres(), ray, at);
    }

    private static double dot(Ray ray, Vec3 v) {
        return ray.directionX() * v.x() + ray.directionY() * v.y() + ray.directionZ() * v.z();
    }

    /** Returns the fraction of the light behind the cloud that passes it. */
    public double transmittance() {
        return transmittance;
    }

    /** Returns the radiance that the cloud sends to the eye, linear RGB. */
    public Vec3 radiance() {
        return outside.irradiance()
                .scaled(sunlight)
                .addScaled(above, outside.above())
                .addScaled(below, outside.below());
    }

    /** Returns how many densities were looked up. */
    public int fetches() {
        return fetches;
    }
}

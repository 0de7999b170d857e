package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * Marches a ray through a cloud's cells, the twin of {@code march.glsl}. Each step is integrated exactly for a constant
 * source, so that a cloud in even light neither gains nor loses energy at any number of steps. Not for several threads.
 */
public final class CellMarch {
    /** The march ends when so little of the diffuse light behind is left; what is behind is then taken as the last. */
    private static final double OPAQUE = 0.01;

    /** Metres of a step per metre of distance. */
    private static final double GROWTH = 0.01;

    private final CellStack cloud;
    private final OutsideOfCloud outside;
    private final List<CellPlace> dense;
    private final List<CellPlace> lit;
    private final Vec3 centre;
    private final double halfX;
    private final double halfZ;
    private double transmittance;
    private double scaledTransmittance;
    private double sunlight;
    private double above;
    private double below;
    private double lightAt;
    private double covered;
    private int fetches;

    /**
     * The light around a cloud.
     *
     * @param towardsSun unit
     * @param irradiance of the sun
     * @param above mean radiance of the upper half of the sky, {@code below} of the lower one
     */
    public record OutsideOfCloud(Vec3 towardsSun, Vec3 irradiance, Vec3 above, Vec3 below) {}

    public CellMarch(CellStack cloud, OutsideOfCloud outside) {
        this.cloud = cloud;
        this.outside = outside;
        dense = cloud.density().stream()
                .map(cells -> new CellPlace(cells.cells()))
                .toList();
        lit = cloud.light().stream().map(cells -> new CellPlace(cells.cells())).toList();
        Aabb box = cloud.narrowest().box();
        centre = new Vec3((box.minX() + box.maxX()) / 2, box.minY(), (box.minZ() + box.maxZ()) / 2);
        halfX = (box.maxX() - box.minX()) / 2;
        halfZ = (box.maxZ() - box.minZ()) / 2;
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
        sunlight = 0;
        above = 0;
        below = 0;
        covered = 0;
        lightAt = 0;
        fetches = 0;
        StackSpan inside = StackSpan.of(cloud, ray);
        double start = Math.max(fromMetres, inside.fromMetres());
        double end = Math.min(toMetres, inside.toMetres());
        double turned = 2 - 2 * dot(ray, outside.towardsSun());
        double at = start;
        double share = offset;
        while (at < end && scaledTransmittance > OPAQUE) {
            double step = stepCells * Math.max(cloud.narrowest().shortest(), GROWTH * at);
            // The first step is cut, so that samples of other offsets lie between.
            double to = Math.min(at + share * step, end);
            step(ray, at, to, turned);
            at = to;
            share = 1;
        }
        finish();
    }

    /** Returns which cells are around a place. */
    private int level(Ray ray, double at) {
        double x = Math.abs(ray.originX() + at * ray.directionX() - centre.x()) / halfX;
        double z = Math.abs(ray.originZ() + at * ray.directionZ() - centre.z()) / halfZ;
        double wide = Math.max(x, z);
        int level = wide <= 1 ? 0 : (int) Math.ceil(Math.log(wide) / Math.log(CellStack.WIDENING) - 1e-6);
        return Math.min(cloud.levels() - 1, level);
    }

    private void step(Ray ray, double from, double to, double turned) {
        double middle = (from + to) / 2;
        int level = level(ray, middle);
        place(dense.get(level), ray, middle);
        fetches++;
        double density = dense.get(level).of(cloud.density().get(level).densities(), 1, 0);
        if (!(density > 0) || !(to > from)) {
            return;
        }
        double depth = density * cloud.greatestPerMetre() * (to - from);
        double mean = meanDepth(depth);
        double lightMetres = from + mean / depth * (to - from);
        int lightLevel = level(ray, lightMetres);
        CellPlace place = lit.get(lightLevel);
        place(place, ray, lightMetres);
        float[] light = cloud.light().get(lightLevel).values();
        double sunDepth = place.of(light, LightCells.VALUES, 0);
        CloudLight physics = cloud.physics();
        CloudOptics optics = physics.optics();
        DeltaScaling medium = physics.medium();
        double scale = medium.depthFactor();
        double taken = -Math.expm1(-depth);
        double scaledTaken = -Math.expm1(-scale * depth);
        double cosine = 1 - turned / 2;
        double eyeDepth = -Math.log(transmittance);
        double narrow = physics.smallAngles().at(turned, sunDepth + eyeDepth + mean) * taken * Math.exp(mean);
        double diffuse = (1 + 3 * medium.g() * cosine) / (4 * Math.PI) * Math.exp(-scale * sunDepth)
                + Math.max(
                        0,
                        place.of(light, LightCells.VALUES, 1)
                                + medium.g() * cosine * place.of(light, LightCells.VALUES, 2));
        lastDiffuse = medium.albedo() * diffuse;
        sunlight += narrow + scaledTransmittance * scaledTaken * lastDiffuse;
        double even = transmittance * taken * optics.albedo();
        above += even * place.of(light, LightCells.VALUES, 3);
        below += even * place.of(light, LightCells.VALUES, 4);
        covered += transmittance * taken;
        lightAt += transmittance * taken * middle;
        transmittance *= 1 - taken;
        scaledTransmittance *= 1 - scaledTaken;
    }

    private double lastDiffuse;

    /** Fills up what the early end has left. */
    private void finish() {
        if (scaledTransmittance <= OPAQUE) {
            sunlight += scaledTransmittance * lastDiffuse;
            above /= covered;
            below /= covered;
            transmittance = 0;
        }
        lightAt = covered > 0 ? lightAt / covered : 0;
        sunlight = Math.max(0, sunlight);
    }

    /** Returns the mean optical depth at which light that a step takes is taken. */
    private static double meanDepth(double depth) {
        if (depth < 1e-3) {
            return depth / 2;
        }
        double left = Math.exp(-depth);
        return 1 - depth * left / (1 - left);
    }

    private void place(CellPlace place, Ray ray, double at) {
        double level = ray.directionX() * ray.directionX() + ray.directionZ() * ray.directionZ();
        double rise = at * at * level / (2 * cloud.planetRadiusMetres());
        place.at(
                ray.originX() + at * ray.directionX(),
                ray.originY() + at * ray.directionY() + rise,
                ray.originZ() + at * ray.directionZ());
    }

    private static double dot(Ray ray, Vec3 v) {
        return ray.directionX() * v.x() + ray.directionY() * v.y() + ray.directionZ() * v.z();
    }

    /** Returns the share of the light behind the cloud that passes it. */
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

    /** Returns the distance of the cloud's visible part, metres. */
    public double metres() {
        return lightAt;
    }

    /** Returns how many densities were looked up. */
    public int fetches() {
        return fetches;
    }
}

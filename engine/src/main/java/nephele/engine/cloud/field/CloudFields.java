package nephele.engine.cloud.field;

import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Makes the extinction field of a cloud of a level at one moment. */
public final class CloudFields {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final Cloud cloud;
    private final double seconds;

    /** Infinite in x and z for a layer. */
    private final Aabb bounds;

    /** The middle of the extent; at x = z = 0 for a layer without drift. */
    private final Vec3 centre;

    /** How far the wind has carried it. */
    private final Vec3 drift;

    private CloudFields(Cloud cloud, double seconds) {
        this.cloud = cloud;
        this.seconds = seconds;
        Vec3 drifted = cloud.motion().drift(seconds);
        if (cloud.extent() instanceof Cloud.Extent.Volume volume) {
            drift = drifted;
            centre = volume.centre().plus(drift);
            bounds = Aabb.around(centre, volume.size());
        } else {
            var layer = (Cloud.Extent.Layer) cloud.extent();
            double base = layer.baseAltitudeMetres();
            double thickness = layer.thicknessMetres();
            drift = new Vec3(drifted.x(), 0, drifted.z());
            centre = drift.plus(new Vec3(0, base + thickness / 2, 0));
            bounds = new Aabb(-INFINITE, base, -INFINITE, INFINITE, base + thickness, INFINITE);
        }
    }

    private boolean isLayer() {
        return bounds.maxX() == INFINITE;
    }

    /** Returns the bounds of a cloud at a time, infinite in x and z for a layer. */
    static Aabb bounds(Cloud cloud, double seconds) {
        return new CloudFields(cloud, seconds).bounds;
    }

    /**
     * Returns the field of a cloud over flat ground.
     *
     * @param seconds simulated time
     * @throws AssetException if a picture or grid of the cloud is unusable
     */
    public static ExtinctionField of(Cloud cloud, AssetSource assets, double seconds) throws AssetException {
        return flat(cloud, CloudFiles.of(cloud, assets, CloudTables::of), seconds, 0);
    }

    /**
     * Returns the field of a cloud over flat ground. In a layer an ellipsoid fills the layer, a picture repeats every 10
     * km, a grid repeats at the width and depth of its own box, and puffs are placed around the layer's middle height.
     *
     * @param slackMetres by which points of a layer may be lower or higher than the walked ray
     */
    static ExtinctionField flat(Cloud cloud, CloudFiles files, double seconds, double slackMetres) {
        return new CloudFields(cloud, seconds).flat(files, slackMetres);
    }

    private ExtinctionField flat(CloudFiles files, double slackMetres) {
        double extinction = cloud.extinctionPerMetre();
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            return noise(noise, files, slackMetres);
        }
        if (cloud.density() instanceof Cloud.Density.Puffs puffs) {
            return new PuffsField(PuffFilling.all(puffs), centre, extinction);
        }
        if (files.voxels() != null) {
            return grid(files, slackMetres);
        }
        return isLayer() ? new UniformField(bounds, extinction) : new EllipsoidField(bounds, extinction);
    }

    private ExtinctionField grid(CloudFiles files, double slackMetres) {
        VoxelGrid voxels = files.voxels();
        double perMetre = files.areDepths() ? 1 / (bounds.maxY() - bounds.minY()) : cloud.extinctionPerMetre();
        if (!isLayer()) {
            return GridField.inBox(voxels, bounds, perMetre);
        }
        Aabb sides = voxels.box();
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            VoxelGrid.requireArea(grid.file(), sides);
        }
        Aabb tile = new Aabb(sides.minX(), bounds.minY(), sides.minZ(), sides.maxX(), bounds.maxY(), sides.maxZ());
        Vec3 by = driftWithin(tile.maxX() - tile.minX(), tile.maxZ() - tile.minZ());
        return GridField.repeated(voxels, tile.moved(by), perMetre, slackMetres);
    }

    /** Returns the drift within one period of a pattern: far drifts are taken modulo it, in double precision. */
    private Vec3 driftWithin(double periodX, double periodZ) {
        return new Vec3(within(drift.x(), periodX), 0, within(drift.z(), periodZ));
    }

    private static double within(double metres, double period) {
        return metres - period * Math.floor(metres / period);
    }

    private ExtinctionField noise(Cloud.Density.Noise noise, CloudFiles files, double slackMetres) {
        double period = NoiseLayouts.PERIOD_FEATURES * noise.featureMetres();
        Vec3 by = driftWithin(period, period);
        Vec3 origin =
                isLayer() ? new Vec3(by.x(), bounds.minY(), by.z()) : new Vec3(centre.x(), bounds.minY(), centre.z());
        NoiseLayouts noises =
                NoiseLayouts.of(noise, files.tables(), cloud.motion().evolutionSeconds(), seconds);
        PlanMap map = files.voxels() == null ? null : coverageMap(files.voxels(), by);
        NoiseDensity density = noise.profile() == null
                ? new EvenNoise(noise, noises, map)
                : new ProfiledNoise(noise, noises, map, bounds);
        return new NoiseField(bounds, origin, density, noise.featureMetres(), cloud.extinctionPerMetre(), slackMetres);
    }

    /** Returns a coverage map relative to the origin of the noise. */
    private PlanMap coverageMap(VoxelGrid greys, Vec3 noiseDrift) {
        if (isLayer()) {
            double tile = CloudFiles.TILE_METRES;
            Vec3 by = driftWithin(tile, tile).minus(noiseDrift);
            return new PlanMap(greys.movedTo(greys.box().moved(by)), GridAxis.Edge.REPEATED);
        }
        var size = new Vec3(bounds.maxX() - bounds.minX(), 1, bounds.maxZ() - bounds.minZ());
        return new PlanMap(greys.movedTo(Aabb.around(Vec3.ZERO, size)), GridAxis.Edge.CLAMPED);
    }
}

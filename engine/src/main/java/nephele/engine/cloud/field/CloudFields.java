package nephele.engine.cloud.field;

import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Makes the extinction field of a cloud of a level. */
public final class CloudFields {
    private CloudFields() {}

    /**
     * Returns the field of a cloud over flat ground at time 0.
     *
     * @throws AssetException if a picture or grid of the cloud is unusable
     */
    public static ExtinctionField of(Cloud cloud, AssetSource assets) throws AssetException {
        return of(cloud, assets, 0);
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
        CloudMoment moment = CloudMoment.of(cloud, seconds);
        Cloud.Density density = cloud.density();
        double extinction = cloud.extinctionPerMetre();
        if (density instanceof Cloud.Density.Puffs puffs) {
            return new PuffsField(PuffFilling.all(puffs), moment.centre(), extinction);
        }
        if (density instanceof Cloud.Density.Noise noise) {
            return noise(cloud, noise, files, seconds, slackMetres);
        }
        if (density instanceof Cloud.Density.Grid grid) {
            return grid(moment, files.grid(), grid.file(), extinction, slackMetres);
        }
        if (density instanceof Cloud.Density.Image image) {
            double perMetre = files.isOpticalDepth() ? 1 / moment.heightMetres() : extinction;
            return grid(moment, files.grid(), image.file(), perMetre, slackMetres);
        }
        return moment.isLayer()
                ? new UniformField(moment.bounds(), extinction)
                : new EllipsoidField(moment.bounds(), extinction);
    }

    private static ExtinctionField grid(
            CloudMoment moment, VoxelGrid voxels, String file, double extinction, double slackMetres) {
        Aabb box = moment.bounds();
        if (!moment.isLayer()) {
            return GridField.inBox(voxels, box, extinction);
        }
        Aabb tile = tile(voxels.box(), box, file);
        Vec3 drift = moment.driftWithin(tile.maxX() - tile.minX(), tile.maxZ() - tile.minZ());
        return GridField.repeated(voxels, tile.moved(drift), extinction, slackMetres);
    }

    /** Returns a box with the sides of one and the heights of the other. */
    private static Aabb tile(Aabb sides, Aabb heights, String file) {
        boolean hasArea = sides.maxX() - sides.minX() > 0
                && sides.maxX() - sides.minX() < Double.POSITIVE_INFINITY
                && sides.maxZ() - sides.minZ() > 0
                && sides.maxZ() - sides.minZ() < Double.POSITIVE_INFINITY;
        if (!hasArea) {
            throw new AssetException(
                    file,
                    "has a bounding box of no width or depth, at which a layer repeats it",
                    "write the box in metres into its header");
        }
        return new Aabb(sides.minX(), heights.minY(), sides.minZ(), sides.maxX(), heights.maxY(), sides.maxZ());
    }

    private static ExtinctionField noise(
            Cloud cloud, Cloud.Density.Noise noise, CloudFiles files, double seconds, double slackMetres) {
        CloudMoment moment = CloudMoment.of(cloud, seconds);
        double period = NoiseLayouts.PERIOD_FEATURES * noise.featureMetres();
        Vec3 drift = moment.driftWithin(period, period);
        Vec3 origin = moment.isLayer()
                ? new Vec3(drift.x(), moment.bounds().minY(), drift.z())
                : new Vec3(
                        moment.centre().x(),
                        moment.bounds().minY(),
                        moment.centre().z());
        NoiseLayouts noises =
                NoiseLayouts.of(noise, files.tables(), cloud.motion().evolutionSeconds(), seconds);
        PlanMap map = coverageMap(moment, files, drift);
        NoiseDensity density = noise.profile() == null
                ? new EvenNoise(noises, noise.coverage(), map, noise.erosion())
                : profiled(noise, moment, noises, new Coverage(noise.coverage(), map));
        return new NoiseField(
                moment.bounds(), origin, density, noise.featureMetres(), cloud.extinctionPerMetre(), slackMetres);
    }

    private static ProfiledNoise profiled(
            Cloud.Density.Noise noise, CloudMoment moment, NoiseLayouts noises, Coverage coverage) {
        HeightProfile profile = HeightProfile.of(noise.profile(), noise.anvil());
        Aabb box = moment.bounds();
        SideWalls walls = moment.isLayer()
                ? null
                : new SideWalls((box.maxX() - box.minX()) / 2, (box.maxZ() - box.minZ()) / 2, profile.spread());
        var bodies = new CloudBodies(noises, coverage, profile, walls);
        return new ProfiledNoise(profile, bodies, noises, noise.erosion(), moment.heightMetres());
    }

    /** Returns the coverage map relative to the origin of the noise; {@code null} if there is none. */
    private static PlanMap coverageMap(CloudMoment moment, CloudFiles files, Vec3 noiseDrift) {
        if (files.coverage() == null) {
            return null;
        }
        if (moment.isLayer()) {
            double tile = CloudPicture.TILE_METRES;
            Vec3 by = moment.driftWithin(tile, tile).minus(noiseDrift);
            return new PlanMap(files.coverage().movedTo(files.coverage().box().moved(by)), GridAxis.Edge.REPEATED);
        }
        Aabb box = moment.bounds();
        var size = new Vec3(box.maxX() - box.minX(), 1, box.maxZ() - box.minZ());
        return new PlanMap(files.coverage().movedTo(Aabb.around(Vec3.ZERO, size)), GridAxis.Edge.CLAMPED);
    }
}

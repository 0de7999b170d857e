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
        double extinction = cloud.extinctionPerMetre();
        if (files instanceof CloudFiles.Voxels voxels) {
            return grid(moment, voxels, extinction, slackMetres);
        }
        if (files instanceof CloudFiles.OfNoise loaded) {
            return noise(cloud, loaded, seconds, slackMetres);
        }
        if (cloud.density() instanceof Cloud.Density.Puffs puffs) {
            return new PuffsField(PuffFilling.all(puffs), moment.centre(), extinction);
        }
        return moment.isLayer()
                ? new UniformField(moment.bounds(), extinction)
                : new EllipsoidField(moment.bounds(), extinction);
    }

    private static ExtinctionField grid(
            CloudMoment moment, CloudFiles.Voxels voxels, double extinction, double slackMetres) {
        Aabb box = moment.bounds();
        double perMetre = voxels.meaning() == CloudFiles.Meaning.OPTICAL_DEPTH ? 1 / moment.heightMetres() : extinction;
        if (!moment.isLayer()) {
            return GridField.inBox(voxels.grid(), box, perMetre);
        }
        Aabb sides = voxels.grid().box();
        VoxelGrid.requireArea(voxels.file(), sides);
        Aabb tile = new Aabb(sides.minX(), box.minY(), sides.minZ(), sides.maxX(), box.maxY(), sides.maxZ());
        Vec3 drift = moment.driftWithin(tile.maxX() - tile.minX(), tile.maxZ() - tile.minZ());
        return GridField.repeated(voxels.grid(), tile.moved(drift), perMetre, slackMetres);
    }

    private static ExtinctionField noise(Cloud cloud, CloudFiles.OfNoise loaded, double seconds, double slackMetres) {
        Cloud.Density.Noise noise = loaded.noise();
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
                NoiseLayouts.of(noise, loaded.tables(), cloud.motion().evolutionSeconds(), seconds);
        PlanMap map = loaded.coverage()
                .map(greys -> coverageMap(moment, greys, drift))
                .orElse(null);
        NoiseDensity density = noise.profile() == null
                ? new EvenNoise(noises, noise.coverage(), map, noise.erosion())
                : profiled(noise, moment, noises, new Coverage(noise.coverage(), map));
        return new NoiseField(
                moment.bounds(), origin, density, noise.featureMetres(), cloud.extinctionPerMetre(), slackMetres);
    }

    private static ProfiledNoise profiled(
            Cloud.Density.Noise noise, CloudMoment moment, NoiseLayouts noises, Coverage coverage) {
        HeightProfile profile = HeightProfile.of(noise.profile(), noise.anvil());
        var bodies = new CloudBodies(noises, coverage, profile, moment.isLayer() ? null : moment.bounds());
        return new ProfiledNoise(profile, bodies, noises, noise.erosion(), moment.heightMetres());
    }

    /** Returns a coverage map relative to the origin of the noise. */
    private static PlanMap coverageMap(CloudMoment moment, VoxelGrid greys, Vec3 noiseDrift) {
        if (moment.isLayer()) {
            double tile = CloudPicture.TILE_METRES;
            Vec3 by = moment.driftWithin(tile, tile).minus(noiseDrift);
            return new PlanMap(greys.movedTo(greys.box().moved(by)), GridAxis.Edge.REPEATED);
        }
        Aabb box = moment.bounds();
        var size = new Vec3(box.maxX() - box.minX(), 1, box.maxZ() - box.minZ());
        return new PlanMap(greys.movedTo(Aabb.around(Vec3.ZERO, size)), GridAxis.Edge.CLAMPED);
    }
}

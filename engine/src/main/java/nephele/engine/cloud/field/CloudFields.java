package nephele.engine.cloud.field;

import java.util.function.IntToDoubleFunction;
import java.util.function.LongFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The extinction fields of a cloud of a level, one for each time, with the files and tables of its density, decoded, which are
 * the same at all times. Pictures are clouds as seen from above, with −z at the top, and become one layer of voxels. Immutable.
 */
public final class CloudFields {
    /** Edge of the square that a picture covers in a layer, which repeats it. */
    private static final double TILE_METRES = 10_000;

    /** The greatest alpha that counts; 1 would be an infinite optical depth. */
    private static final double OPAQUE = 254.5 / 255;

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private final Cloud cloud;
    /** Densities of a grid or picture, or the coverage map of noise; {@code null} for none. */
    private final VoxelGrid voxels;
    /** True if the voxels are the vertical optical depths of columns. */
    private final boolean areDepths;
    /** The tables of the cloud's noise; {@code null} for another density. */
    private final CloudTables tables;

    private CloudFields(Cloud cloud, VoxelGrid voxels, boolean areDepths, CloudTables tables) {
        this.cloud = cloud;
        this.voxels = voxels;
        this.areDepths = areDepths;
        this.tables = tables;
    }

    /**
     * Reads the files of a cloud.
     *
     * @param tables makes or remembers the tables of a seed
     * @throws AssetException if a picture or grid is unusable
     */
    public static CloudFields of(Cloud cloud, AssetSource assets, LongFunction<CloudTables> tables)
            throws AssetException {
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            return new CloudFields(cloud, VoxelGrid.read(grid.file(), assets.bytes(grid.file())), false, null);
        }
        if (cloud.density() instanceof Cloud.Density.Image image) {
            Picture picture = picture(image.file(), assets);
            return new CloudFields(cloud, densities(picture), hasAlpha(picture), null);
        }
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            String map = noise.coverageMap();
            VoxelGrid coverage = map == null ? null : greys(picture(map, assets));
            return new CloudFields(cloud, coverage, false, tables.apply(noise.seed()));
        }
        return new CloudFields(cloud, null, false, null);
    }

    private static Picture picture(String file, AssetSource assets) {
        return PictureDecoder.decodeNumbers(file, assets.bytes(file));
    }

    private static boolean hasAlpha(Picture picture) {
        return picture.channels() == 2 || picture.channels() == 4;
    }

    /** Returns the optical depths −ln(1 − alpha) of the columns of a picture with alpha, otherwise the greys. */
    static VoxelGrid densities(Picture picture) {
        if (!hasAlpha(picture)) {
            return greys(picture);
        }
        int alpha = picture.channels() - 1;
        return layer(picture, pixel -> -StrictMath.log(1 - Math.min(unit(picture, pixel, alpha), OPAQUE)));
    }

    /** Returns the means of the colours, 0 to 1. */
    static VoxelGrid greys(Picture picture) {
        int colours = picture.channels() < 3 ? 1 : 3;
        return layer(picture, pixel -> {
            double sum = 0;
            for (int channel = 0; channel < colours; channel++) {
                sum += unit(picture, pixel, channel);
            }
            return sum / colours;
        });
    }

    private static double unit(Picture picture, int pixel, int channel) {
        int value = picture.sample(pixel % picture.width(), pixel / picture.width(), channel);
        return value / (picture.bitsPerChannel() == 8 ? 255.0 : 65535.0);
    }

    private static VoxelGrid layer(Picture picture, IntToDoubleFunction valueOfPixel) {
        float[] values = new float[picture.width() * picture.height()];
        for (int pixel = 0; pixel < values.length; pixel++) {
            values[pixel] = (float) valueOfPixel.applyAsDouble(pixel);
        }
        double half = TILE_METRES / 2;
        return new VoxelGrid(picture.width(), 1, picture.height(), new Aabb(-half, 0, -half, half, 1, half), values);
    }

    public Cloud cloud() {
        return cloud;
    }

    /** Returns the fields of a cloud that differs from this one in other things than files. */
    CloudFields with(Cloud changed) {
        return new CloudFields(changed, voxels, areDepths, tables);
    }

    private boolean isLayer() {
        return cloud.extent() instanceof Cloud.Extent.Layer;
    }

    /** Returns how far the wind has carried it. */
    private Vec3 drift(double seconds) {
        Vec3 drifted = cloud.motion().drift(seconds);
        return isLayer() ? new Vec3(drifted.x(), 0, drifted.z()) : drifted;
    }

    /** Returns the middle of the extent; at x = z = 0 for a layer without drift. */
    private Vec3 centre(double seconds) {
        if (cloud.extent() instanceof Cloud.Extent.Volume volume) {
            return volume.centre().plus(drift(seconds));
        }
        var layer = (Cloud.Extent.Layer) cloud.extent();
        return drift(seconds).plus(new Vec3(0, layer.baseAltitudeMetres() + layer.thicknessMetres() / 2, 0));
    }

    /** Returns the bounds at a time, infinite in x and z for a layer. */
    Aabb bounds(double seconds) {
        if (cloud.extent() instanceof Cloud.Extent.Volume volume) {
            return Aabb.around(centre(seconds), volume.size());
        }
        var layer = (Cloud.Extent.Layer) cloud.extent();
        double base = layer.baseAltitudeMetres();
        return new Aabb(-INFINITE, base, -INFINITE, INFINITE, base + layer.thicknessMetres(), INFINITE);
    }

    /**
     * Returns the field over flat ground. In a layer an ellipsoid fills the layer, a picture repeats every 10 km, a grid
     * repeats at the width and depth of its own box, and puffs are placed around the layer's middle height.
     *
     * @param seconds simulated time
     * @param slackMetres by which points of a layer may be lower or higher than the walked ray
     * @throws AssetException if the grid of a layer has no area
     */
    public ExtinctionField flat(double seconds, double slackMetres) {
        double extinction = cloud.extinctionPerMetre();
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            return noise(noise, seconds, slackMetres);
        }
        if (cloud.density() instanceof Cloud.Density.Puffs puffs) {
            return new PuffsField(PuffFilling.all(puffs), centre(seconds), extinction);
        }
        if (voxels != null) {
            return grid(seconds, slackMetres);
        }
        Aabb bounds = bounds(seconds);
        return isLayer() ? new UniformField(bounds, extinction) : new EllipsoidField(bounds, extinction);
    }

    private ExtinctionField grid(double seconds, double slackMetres) {
        Aabb bounds = bounds(seconds);
        double perMetre = areDepths ? 1 / (bounds.maxY() - bounds.minY()) : cloud.extinctionPerMetre();
        if (!isLayer()) {
            return GridField.inBox(voxels, bounds, perMetre);
        }
        Aabb sides = voxels.box();
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            VoxelGrid.requireArea(grid.file(), sides);
        }
        Aabb tile = new Aabb(sides.minX(), bounds.minY(), sides.minZ(), sides.maxX(), bounds.maxY(), sides.maxZ());
        Vec3 by = driftWithin(seconds, tile.maxX() - tile.minX(), tile.maxZ() - tile.minZ());
        return GridField.repeated(voxels, tile.moved(by), perMetre, slackMetres);
    }

    /** Returns the drift within one period of a pattern: far drifts are taken modulo it, in double precision. */
    private Vec3 driftWithin(double seconds, double periodX, double periodZ) {
        Vec3 drift = drift(seconds);
        return new Vec3(within(drift.x(), periodX), 0, within(drift.z(), periodZ));
    }

    private static double within(double metres, double period) {
        return metres - period * Math.floor(metres / period);
    }

    private ExtinctionField noise(Cloud.Density.Noise noise, double seconds, double slackMetres) {
        Aabb bounds = bounds(seconds);
        Vec3 centre = centre(seconds);
        double period = EvolvingNoise.PERIOD_FEATURES * noise.featureMetres();
        Vec3 by = driftWithin(seconds, period, period);
        Vec3 origin =
                isLayer() ? new Vec3(by.x(), bounds.minY(), by.z()) : new Vec3(centre.x(), bounds.minY(), centre.z());
        double evolution = cloud.motion().evolutionSeconds();
        PlanMap map = voxels == null ? null : coverageMap(seconds, by);
        NoiseDensity density = noise.profile() == null
                ? new EvenNoise(noise, tables, evolution, seconds, map)
                : new ProfiledNoise(noise, tables, evolution, seconds, map, bounds);
        return new NoiseField(bounds, origin, density, noise.featureMetres(), cloud.extinctionPerMetre(), slackMetres);
    }

    /** Returns a coverage map relative to the origin of the noise. */
    private PlanMap coverageMap(double seconds, Vec3 noiseDrift) {
        if (isLayer()) {
            double tile = TILE_METRES;
            Vec3 by = driftWithin(seconds, tile, tile).minus(noiseDrift);
            return new PlanMap(voxels.movedTo(voxels.box().moved(by)), GridAxis.Edge.REPEATED);
        }
        Aabb bounds = bounds(seconds);
        var size = new Vec3(bounds.maxX() - bounds.minX(), 1, bounds.maxZ() - bounds.minZ());
        return new PlanMap(voxels.movedTo(Aabb.around(Vec3.ZERO, size)), GridAxis.Edge.CLAMPED);
    }
}

package nephele.engine.cloud.field;

import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Makes the extinction field of a cloud of a level. */
public final class CloudFields {
    /** Edge of the square that a picture covers in a layer, which repeats it. */
    private static final double PICTURE_TILE_METRES = 10_000;

    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private CloudFields() {}

    /**
     * Returns the field of a cloud. In a layer an ellipsoid fills the layer, a picture repeats every 10 km, a grid
     * repeats at the width and depth of its own box, and puffs are placed around the layer's middle height at x = z = 0.
     *
     * @throws AssetException if the picture or grid of the cloud is unusable
     */
    public static ExtinctionField of(Cloud cloud, AssetSource assets) throws AssetException {
        Cloud.Density density = cloud.density();
        double extinction = cloud.extinctionPerMetre();
        Aabb box = box(cloud.extent());
        boolean isLayer = cloud.extent() instanceof Cloud.Extent.Layer;
        if (density instanceof Cloud.Density.Puffs puffs) {
            return new PuffsField(puffs.puffs(), centre(cloud.extent()), extinction);
        }
        if (density instanceof Cloud.Density.Noise noise) {
            return new NoiseField(box, noise.seed(), noise.featureMetres(), noise.coverage(), extinction);
        }
        if (density instanceof Cloud.Density.Grid grid) {
            VoxelGrid voxels = VolFile.parse(grid.file(), assets.bytes(grid.file()));
            return isLayer
                    ? GridField.repeated(voxels, tile(voxels.box(), box, grid.file()), extinction)
                    : GridField.inBox(voxels, box, extinction);
        }
        if (density instanceof Cloud.Density.Image image) {
            VoxelGrid voxels = seenFromAbove(PictureDecoder.decode(image.file(), assets.bytes(image.file())));
            return isLayer
                    ? GridField.repeated(voxels, tile(voxels.box(), box, image.file()), extinction)
                    : GridField.inBox(voxels, box, extinction);
        }
        return isLayer ? new UniformField(box, extinction) : new EllipsoidField(box, extinction);
    }

    private static Aabb box(Cloud.Extent extent) {
        if (extent instanceof Cloud.Extent.Volume volume) {
            return Aabb.around(volume.centre(), volume.size());
        }
        var layer = (Cloud.Extent.Layer) extent;
        double top = layer.baseAltitudeMetres() + layer.thicknessMetres();
        return new Aabb(-INFINITE, layer.baseAltitudeMetres(), -INFINITE, INFINITE, top, INFINITE);
    }

    private static Vec3 centre(Cloud.Extent extent) {
        if (extent instanceof Cloud.Extent.Volume volume) {
            return volume.centre();
        }
        var layer = (Cloud.Extent.Layer) extent;
        return new Vec3(0, layer.baseAltitudeMetres() + layer.thicknessMetres() / 2, 0);
    }

    /** Returns a box with the sides of one and the heights of the other. */
    private static Aabb tile(Aabb sides, Aabb heights, String file) {
        boolean hasArea = sides.maxX() - sides.minX() > 0
                && sides.maxX() - sides.minX() < INFINITE
                && sides.maxZ() - sides.minZ() > 0
                && sides.maxZ() - sides.minZ() < INFINITE;
        if (!hasArea) {
            throw new AssetException(
                    file,
                    "has a bounding box of no width or depth, at which a layer repeats it",
                    "write the box in metres into its header");
        }
        return new Aabb(sides.minX(), heights.minY(), sides.minZ(), sides.maxX(), heights.maxY(), sides.maxZ());
    }

    /** Returns the densities of a picture with −z at its top, in one layer of voxels; colours count by their mean. */
    private static VoxelGrid seenFromAbove(Picture picture) {
        int colours = picture.channels() < 3 ? 1 : 3;
        float most = colours * (picture.bitsPerChannel() == 8 ? 255f : 65535f);
        float[] values = new float[picture.width() * picture.height()];
        for (int pixel = 0; pixel < values.length; pixel++) {
            int sum = 0;
            for (int channel = 0; channel < colours; channel++) {
                sum += picture.sample(pixel % picture.width(), pixel / picture.width(), channel);
            }
            values[pixel] = sum / most;
        }
        double half = PICTURE_TILE_METRES / 2;
        return new VoxelGrid(picture.width(), 1, picture.height(), new Aabb(-half, 0, -half, half, 1, half), values);
    }
}

package nephele.engine.cloud.field;

import java.util.function.LongFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VolFile;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;

/**
 * The files and tables of a cloud's density, decoded; they are the same at all times.
 *
 * @param grid densities of a grid or a picture; {@code null} for other densities
 * @param isOpticalDepth true if the grid holds the vertical optical depth of columns instead
 * @param coverage {@code null} without a coverage map
 * @param tables {@code null} without noise
 */
record CloudFiles(VoxelGrid grid, boolean isOpticalDepth, VoxelGrid coverage, CloudTables tables) {
    private static final CloudFiles NONE = new CloudFiles(null, false, null, null);

    /**
     * Reads the files of a cloud.
     *
     * @param tables makes or remembers the tables of a seed
     * @throws AssetException if a picture or grid is unusable
     */
    static CloudFiles of(Cloud cloud, AssetSource assets, LongFunction<CloudTables> tables) {
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            return new CloudFiles(VolFile.parse(grid.file(), assets.bytes(grid.file())), false, null, null);
        }
        if (cloud.density() instanceof Cloud.Density.Image image) {
            var picture = PictureDecoder.decode(image.file(), assets.bytes(image.file()));
            return new CloudFiles(CloudPicture.densities(picture), CloudPicture.hasAlpha(picture), null, null);
        }
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            String map = noise.coverageMap();
            VoxelGrid coverage = map == null ? null : CloudPicture.greys(PictureDecoder.decode(map, assets.bytes(map)));
            return new CloudFiles(null, false, coverage, tables.apply(noise.seed()));
        }
        return NONE;
    }
}

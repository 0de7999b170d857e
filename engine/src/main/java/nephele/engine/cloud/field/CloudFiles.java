package nephele.engine.cloud.field;

import java.util.Optional;
import java.util.function.LongFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;

/** The files and tables of a cloud's density, decoded; they are the same at all times. */
sealed interface CloudFiles {
    /**
     * The densities of a grid or a picture.
     *
     * @param file names them in errors
     */
    record Voxels(String file, VoxelGrid grid, Meaning meaning) implements CloudFiles {}

    /** What the numbers of a grid are. */
    enum Meaning {
        DENSITY,
        /** The vertical optical depth of columns. */
        OPTICAL_DEPTH
    }

    /** The tables of noise, and its coverage map if it has one. */
    record OfNoise(Cloud.Density.Noise noise, CloudTables tables, Optional<VoxelGrid> coverage) implements CloudFiles {}

    /** A density in closed form needs none. */
    record None() implements CloudFiles {}

    /**
     * Reads the files of a cloud.
     *
     * @param tables makes or remembers the tables of a seed
     * @throws AssetException if a picture or grid is unusable
     */
    static CloudFiles of(Cloud cloud, AssetSource assets, LongFunction<CloudTables> tables) {
        if (cloud.density() instanceof Cloud.Density.Grid grid) {
            String file = grid.file();
            return new Voxels(file, VoxelGrid.read(file, assets.bytes(file)), Meaning.DENSITY);
        }
        if (cloud.density() instanceof Cloud.Density.Image image) {
            var picture = PictureDecoder.decodeNumbers(image.file(), assets.bytes(image.file()));
            Meaning meaning = CloudPicture.hasAlpha(picture) ? Meaning.OPTICAL_DEPTH : Meaning.DENSITY;
            return new Voxels(image.file(), CloudPicture.densities(picture), meaning);
        }
        if (cloud.density() instanceof Cloud.Density.Noise noise) {
            Optional<VoxelGrid> coverage = Optional.ofNullable(noise.coverageMap())
                    .map(map -> CloudPicture.greys(PictureDecoder.decodeNumbers(map, assets.bytes(map))));
            return new OfNoise(noise, tables.apply(noise.seed()), coverage);
        }
        return new None();
    }
}

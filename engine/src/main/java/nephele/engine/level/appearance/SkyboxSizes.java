package nephele.engine.level.appearance;

import nephele.engine.asset.AssetException;

/** The required sizes of a skybox's pictures, in pixels. */
public final class SkyboxSizes {
    private SkyboxSizes() {}

    /**
     * Requires a square face.
     *
     * @param side side of the first face
     */
    public static void requireFace(String file, int width, int height, int side) {
        if (width != side || height != side) {
            throw new AssetException(
                    file,
                    "is " + width + " x " + height + " pixels",
                    "the six faces of a skybox must be squares of one size, here " + side);
        }
    }

    /** Returns the side of each face in a cross of four columns and three rows. */
    public static int crossSide(String file, int width, int height) {
        int side = width / 4;
        if (side == 0 || width != 4 * side || height != 3 * side) {
            throw new AssetException(
                    file,
                    "is " + width + " x " + height + " pixels",
                    "a skybox cross has four columns and three rows of squares");
        }
        return side;
    }
}

package nephele.engine.render.pass.sky;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxSizes;

/**
 * Six square pictures in the order +x −x +y −y +z −z, each as seen from the centre: sides with world up upwards, +y
 * with its bottom edge at −z, −y with its top edge at −z. A cross has four columns and three rows: −x −z +x +z in the
 * middle row, +y above −z, −y below it.
 */
record SkyboxLayers(int side, List<Picture> pictures) {
    /** Column and row of each face in a cross. */
    private static final int[][] CROSS_CELLS = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};

    static SkyboxLayers of(Sky.Skybox sky, Function<String, Picture> pictureOf) {
        return sky.layout() == SkyboxLayout.CROSS
                ? cross(sky.files().get(0), pictureOf)
                : faces(sky.files(), pictureOf);
    }

    private static SkyboxLayers faces(List<String> files, Function<String, Picture> pictureOf) {
        List<Picture> pictures = new ArrayList<>();
        for (String file : files) {
            Picture picture = pictureOf.apply(file).toRgba8();
            int side = pictures.isEmpty() ? picture.width() : pictures.get(0).width();
            SkyboxSizes.requireFace(file, picture.width(), picture.height(), side);
            pictures.add(picture);
        }
        return new SkyboxLayers(pictures.get(0).width(), pictures);
    }

    private static SkyboxLayers cross(String file, Function<String, Picture> pictureOf) {
        Picture whole = pictureOf.apply(file).toRgba8();
        int side = SkyboxSizes.crossSide(file, whole.width(), whole.height());
        List<Picture> pictures = new ArrayList<>();
        for (int[] cell : CROSS_CELLS) {
            pictures.add(cut(whole, cell[0] * side, cell[1] * side, side));
        }
        return new SkyboxLayers(side, pictures);
    }

    private static Picture cut(Picture whole, int left, int top, int side) {
        byte[] samples = new byte[4 * side * side];
        for (int y = 0; y < side; y++) {
            System.arraycopy(whole.samples(), 4 * ((top + y) * whole.width() + left), samples, 4 * y * side, 4 * side);
        }
        return new Picture(side, side, 4, 8, samples);
    }
}

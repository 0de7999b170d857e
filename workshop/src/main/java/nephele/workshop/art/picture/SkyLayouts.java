package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxSquare;

/** The sky over the bay in small pictures for the sample levels of the layouts that other programs use. */
public final class SkyLayouts {
    private static final int SIDE_PIXELS = 128;
    private static final List<SkyboxLayout> LAYOUTS =
            List.of(SkyboxLayout.OPENGL, SkyboxLayout.QUAKE2, SkyboxLayout.TERRAGEN);

    private SkyLayouts() {}

    /** Returns the asset ids of a layout in its order, in the format that its programs write. */
    static List<String> files(SkyboxLayout layout) {
        return SkyboxSquare.of(layout).stream()
                .map(square -> file(layout, square.name()))
                .toList();
    }

    private static String file(SkyboxLayout layout, String name) {
        return switch (layout) {
            case QUAKE2 -> "textures/sky-bay-quake2/bay_" + name + ".tga";
            case TERRAGEN -> "textures/sky-bay-terragen/" + name + ".bmp";
            case OPENGL, FACES, CROSS -> "textures/sky-bay-opengl/" + name + ".png";
        };
    }

    /** Returns the painted pictures by asset id. */
    public static Map<String, BufferedImage> all() {
        Map<String, BufferedImage> pictures = new LinkedHashMap<>();
        SkyPainter painter = new SkyPainter();
        for (SkyboxLayout layout : LAYOUTS) {
            List<String> files = files(layout);
            for (int i = 0; i < files.size(); i++) {
                SkyboxSquare square = SkyboxSquare.of(layout).get(i);
                pictures.put(files.get(i), painter.square(square, SIDE_PIXELS));
            }
        }
        return pictures;
    }
}

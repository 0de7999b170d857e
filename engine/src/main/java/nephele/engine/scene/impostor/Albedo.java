package nephele.engine.scene.impostor;

import nephele.engine.asset.Picture;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.math.Vec3;

/** The colour of a material's surface, with the light that a lobe would reflect: impostors are matt. */
final class Albedo {
    private final Vec3 base;
    private final double lobe;
    /** {@code null} without a texture. */
    private final Picture picture;

    private final double[] linear;

    /** @param picture 8-bit RGBA; {@code null} without a texture */
    Albedo(Material material, Picture picture, ColourDecoding decoding) {
        this.picture = picture;
        base = material.baseColour();
        lobe = ImpostorAtlas.lobe(material);
        linear = decoding.table();
    }

    /** Adds the linear colour at texture coordinates. @param t 0 at the picture's top row */
    void add(double s, double t, float[] sum) {
        double red = base.x();
        double green = base.y();
        double blue = base.z();
        if (picture != null) {
            int x = (int) ((s - Math.floor(s)) * picture.width()) % picture.width();
            int y = (int) ((t - Math.floor(t)) * picture.height()) % picture.height();
            red *= linear[picture.sample(x, y, 0)];
            green *= linear[picture.sample(x, y, 1)];
            blue *= linear[picture.sample(x, y, 2)];
        }
        sum[0] += red + (1 - red) * lobe;
        sum[1] += green + (1 - green) * lobe;
        sum[2] += blue + (1 - blue) * lobe;
    }
}

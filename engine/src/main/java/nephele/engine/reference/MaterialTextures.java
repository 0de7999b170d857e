package nephele.engine.reference;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The level's materials with their pictures. Pictures are read at the hit point; averaging many rays filters them. */
final class MaterialTextures {
    private static final Skin GREY = new Skin(Material.DEFAULT_GREY, null, null);

    private final Map<String, Skin> byId = new HashMap<>();

    /** A material; its pictures are {@code null} if it has none. */
    record Skin(Material material, RepeatedPicture colour, RepeatedPicture normals) {}

    /**
     * The texture coordinates and the texture's directions at a point.
     *
     * @param s texture coordinate along {@code across}
     * @param t texture coordinate against {@code up}
     */
    record Spot(double s, double t, Vector3dc across, Vector3dc up) {}

    /**
     * A point of a surface without its material.
     *
     * @param normal of the surface that the geometry approximates
     * @param faceNormal of the geometry
     */
    record Bare(int item, Vec3 place, Vector3dc normal, Vector3dc faceNormal, Vector3dc toEye) {
        /** Makes a point of an exact geometry. */
        Bare(int item, Vec3 place, Vector3dc normal, Vector3dc toEye) {
            this(item, place, normal, normal, toEye);
        }
    }

    /**
     * Reads the pictures.
     *
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    MaterialTextures(List<Material> materials, AssetSource assets, ColourDecoding decoding) {
        Map<String, RepeatedPicture> colours = new HashMap<>();
        Map<String, RepeatedPicture> normals = new HashMap<>();
        for (Material material : materials) {
            byId.put(
                    material.id(),
                    new Skin(
                            material,
                            picture(material.texture(), colours, id -> colour(id, assets, decoding)),
                            picture(material.normalTexture(), normals, id -> normal(id, assets))));
        }
    }

    private static RepeatedPicture picture(
            String id, Map<String, RepeatedPicture> known, Function<String, RepeatedPicture> read) {
        return id == null ? null : known.computeIfAbsent(id, read);
    }

    private static RepeatedPicture colour(String id, AssetSource assets, ColourDecoding decoding) {
        return new RepeatedPicture(PictureDecoder.decode(id, assets.bytes(id)), decoding);
    }

    private static RepeatedPicture normal(String id, AssetSource assets) {
        return new RepeatedPicture(PictureDecoder.decodeNumbers(id, assets.bytes(id)), ColourDecoding.AS_STORED);
    }

    /** Returns the default grey for {@code null} and for unknown ids. */
    Skin skin(String material) {
        return byId.getOrDefault(material, GREY);
    }

    /** Returns the base colour of a material at a place of its pictures. */
    static Vector3d colour(Skin skin, double s, double t) {
        double[] rgba = {1, 1, 1, 1};
        if (skin.colour() != null) {
            skin.colour().read(s, t, rgba);
        }
        return skin.material().baseColour().toVector().mul(rgba[0], rgba[1], rgba[2]);
    }

    static SurfacePoint covered(Bare bare, Skin skin, Spot spot) {
        Material material = skin.material();
        Vector3d colour = colour(skin, spot.s(), spot.t());
        double[] rgba = {1, 1, 1, 1};
        Vector3dc normal = bare.normal();
        if (skin.normals() != null) {
            skin.normals().read(spot.s(), spot.t(), rgba);
            normal = FaceTexture.mappedNormal(
                    new Vector3d(rgba[0], rgba[1], rgba[2]), bare.normal(), spot.across(), spot.up());
        }
        Brdf gloss = material.lambert() ? null : gloss(material, colour, rgba[3], normal.dot(bare.toEye()));
        return new SurfacePoint(
                bare.item(),
                bare.place(),
                normal,
                bare.normal(),
                bare.faceNormal(),
                colour,
                gloss,
                bare.toEye(),
                material.emission(),
                false);
    }

    private static Brdf gloss(Material material, Vector3dc colour, double roughnessFactor, double cosine) {
        double roughness = material.roughness() == null ? 1 : material.roughness();
        double metallic = material.metallic() == null ? 0 : material.metallic();
        return Brdf.of(colour, roughness * roughnessFactor, metallic, cosine);
    }

    /** A picture that repeats in both directions, interpolated bilinearly between its pixel centres, in linear values. */
    static final class RepeatedPicture {
        private final Picture picture;
        private final double[] linear;

        RepeatedPicture(Picture picture, ColourDecoding decoding) {
            this.picture = picture.toRgba8();
            linear = decoding.table();
        }

        /**
         * Writes red, green, blue and alpha (never decoded) at texture coordinates.
         *
         * @param t 0 at the top row, growing downwards
         */
        void read(double s, double t, double[] rgba) {
            double x = (s - Math.floor(s)) * picture.width() - 0.5;
            double y = (t - Math.floor(t)) * picture.height() - 0.5;
            int left = (int) Math.floor(x);
            int top = (int) Math.floor(y);
            double fx = x - left;
            double fy = y - top;
            int right = left + 1 == picture.width() ? 0 : left + 1;
            int bottom = top + 1 == picture.height() ? 0 : top + 1;
            left = left < 0 ? picture.width() - 1 : left;
            top = top < 0 ? picture.height() - 1 : top;
            Arrays.fill(rgba, 0);
            add(left, top, (1 - fx) * (1 - fy), rgba);
            add(right, top, fx * (1 - fy), rgba);
            add(left, bottom, (1 - fx) * fy, rgba);
            add(right, bottom, fx * fy, rgba);
        }

        private void add(int column, int row, double weight, double[] rgba) {
            byte[] samples = picture.samples();
            int at = 4 * (row * picture.width() + column);
            for (int channel = 0; channel < 3; channel++) {
                rgba[channel] += weight * linear[samples[at + channel] & 0xff];
            }
            rgba[3] += weight * ((samples[at + 3] & 0xff) / 255.0);
        }
    }
}

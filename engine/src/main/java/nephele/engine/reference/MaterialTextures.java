package nephele.engine.reference;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;
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
                null);
    }

    private static Brdf gloss(Material material, Vector3dc colour, double roughnessFactor, double cosine) {
        double roughness = material.roughness() == null ? 1 : material.roughness();
        double metallic = material.metallic() == null ? 0 : material.metallic();
        return Brdf.of(colour, roughness * roughnessFactor, metallic, cosine);
    }
}

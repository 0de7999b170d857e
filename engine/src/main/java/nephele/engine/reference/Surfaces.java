package nephele.engine.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.appearance.NormalMap;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** What each face of each solid is made of. Pictures are read where a ray meets them; many rays make the filter. */
final class Surfaces {
    private final List<List<Face>> faces;

    /** Its pictures are {@code null} where the material has none. */
    private record Skin(Material material, RepeatedPicture colour, RepeatedPicture normals) {}

    private record Face(Vector3dc normal, FaceTexture texture, Skin skin) {}

    /** @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used */
    Surfaces(List<Brush> brushes, List<Material> materials, AssetSource assets, Decoding decoding) {
        Map<String, RepeatedPicture> colours = new HashMap<>();
        Map<String, RepeatedPicture> normals = new HashMap<>();
        Map<String, Skin> skins = new HashMap<>();
        for (Material material : materials) {
            skins.put(
                    material.id(),
                    new Skin(
                            material,
                            picture(material.texture(), assets, decoding, colours),
                            picture(material.normalTexture(), assets, Decoding.AS_STORED, normals)));
        }
        Skin grey = new Skin(Material.DEFAULT_GREY, null, null);
        faces = new ArrayList<>();
        for (Brush brush : brushes) {
            faces.add(brush.faces().stream()
                    .map(face -> face(face, skins.getOrDefault(face.material(), grey)))
                    .toList());
        }
    }

    private static RepeatedPicture picture(
            String id, AssetSource assets, Decoding decoding, Map<String, RepeatedPicture> known) {
        return id == null
                ? null
                : known.computeIfAbsent(
                        id, name -> new RepeatedPicture(PictureDecoder.decode(name, assets.bytes(name)), decoding));
    }

    private static Face face(BrushFace face, Skin skin) {
        double metres = skin.material().textureMetres();
        return new Face(face.plane().normal().toVector(), FaceTexture.of(face, metres), skin);
    }

    /** @param toEye unit */
    SurfacePoint at(int solid, int faceIndex, Vec3 place, Vector3dc toEye) {
        Face face = faces.get(solid).get(faceIndex);
        Material material = face.skin.material();
        double[] rgba = {1, 1, 1, 1};
        if (face.skin.colour() != null) {
            face.skin.colour().read(face.texture.s(place), face.texture.t(place), rgba);
        }
        Vector3d colour = material.baseColour().toVector().mul(rgba[0], rgba[1], rgba[2]);
        Vector3dc normal = face.normal;
        rgba[3] = 1;
        if (face.skin.normals() != null) {
            face.skin.normals().read(face.texture.s(place), face.texture.t(place), rgba);
            normal = NormalMap.mapped(
                    new Vector3d(rgba[0], rgba[1], rgba[2]),
                    face.normal,
                    face.texture.across().toVector(),
                    face.texture.up().toVector());
        }
        Brdf gloss = material.lambert() ? null : gloss(material, colour, rgba[3], normal.dot(toEye));
        return new SurfacePoint(solid, place, normal, face.normal, colour, gloss, toEye, material.emission());
    }

    private static Brdf gloss(Material material, Vector3dc colour, double roughnessFactor, double cosine) {
        double roughness = material.roughness() == null ? 1 : material.roughness();
        double metallic = material.metallic() == null ? 0 : material.metallic();
        return Brdf.of(colour, roughness * roughnessFactor, metallic, cosine);
    }
}

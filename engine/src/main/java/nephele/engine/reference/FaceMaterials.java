package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Vec3;
import nephele.engine.reference.MaterialTextures.Bare;
import nephele.engine.reference.MaterialTextures.Skin;
import nephele.engine.reference.MaterialTextures.Spot;
import org.joml.Vector3dc;

/** The materials of all faces of all solids. */
final class FaceMaterials {
    private final List<List<Face>> faces;

    private record Face(Vector3dc normal, FaceTexture texture, Vector3dc across, Vector3dc up, Skin skin) {}

    FaceMaterials(List<Brush> brushes, MaterialTextures textures) {
        faces = brushes.stream()
                .map(brush -> brush.faces().stream()
                        .map(face -> face(face, textures.skin(face.material())))
                        .toList())
                .toList();
    }

    private static Face face(BrushFace face, Skin skin) {
        FaceTexture texture = FaceTexture.of(face, skin.material().textureMetres());
        return new Face(
                face.plane().normal().toVector(),
                texture,
                texture.across().toVector(),
                texture.up().toVector(),
                skin);
    }

    /**
     * Returns a point of a solid's surface.
     *
     * @param toEye unit
     */
    SurfacePoint at(int solid, int faceIndex, Vec3 place, Vector3dc toEye) {
        Face face = faces.get(solid).get(faceIndex);
        FaceTexture texture = face.texture;
        Spot spot = new Spot(texture.s(place), texture.t(place), face.across, face.up);
        return MaterialTextures.covered(new Bare(solid, place, face.normal, toEye), face.skin, spot);
    }
}

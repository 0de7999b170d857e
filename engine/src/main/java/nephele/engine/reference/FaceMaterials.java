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

/** The materials of all faces of all solids. Immutable. */
final class FaceMaterials {
    static final FaceMaterials NONE = new FaceMaterials(new Face[0][]);

    private final Face[][] faces;

    private record Face(Vector3dc normal, FaceTexture texture, Vector3dc across, Vector3dc up, Skin skin) {}

    private FaceMaterials(Face[][] faces) {
        this.faces = faces;
    }

    static FaceMaterials of(List<Brush> brushes, MaterialTextures textures) {
        return new FaceMaterials(brushes.stream()
                .map(brush -> brush.faces().stream()
                        .map(face -> face(face, textures.skin(face.material())))
                        .toArray(Face[]::new))
                .toArray(Face[][]::new));
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

    /** Returns true if an item is a solid of these. */
    boolean has(int item) {
        return item < faces.length;
    }

    /** Returns true if a face of a solid is a mirror. */
    boolean isMirror(int solid, int face) {
        return faces[solid][face].skin.material().mirror();
    }

    /** Returns the factor of a mirror on radiance, linear RGB. */
    Vec3 mirrorTint(int solid, int face) {
        return faces[solid][face].skin.material().baseColour();
    }

    /** Returns the outward unit normal of a face. */
    Vec3 normal(int solid, int face) {
        return Vec3.of(faces[solid][face].normal);
    }

    /**
     * Returns a point of a solid's surface.
     *
     * @param toEye unit
     */
    SurfacePoint at(int solid, int faceIndex, Vec3 place, Vector3dc toEye) {
        Face face = faces[solid][faceIndex];
        FaceTexture texture = face.texture;
        Spot spot = new Spot(texture.s(place), texture.t(place), face.across, face.up);
        return MaterialTextures.covered(new Bare(solid, place, face.normal, toEye), face.skin, spot);
    }
}

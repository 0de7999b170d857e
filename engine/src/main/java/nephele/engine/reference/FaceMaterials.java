package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.reference.MaterialTextures.Bare;
import nephele.engine.reference.MaterialTextures.Skin;
import nephele.engine.reference.MaterialTextures.Spot;
import org.joml.Vector3dc;

/** The materials of all faces of all solids. Immutable. */
final class FaceMaterials {
    static final FaceMaterials NONE = new FaceMaterials(new Face[0][]);

    private final Face[][] faces;

    private record Face(
            List<Vec3> polygon, Vector3dc normal, FaceTexture texture, Vector3dc across, Vector3dc up, Skin skin) {}

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
                face.polygon(),
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

    /** A face that is a mirror. */
    record Mirror(int solid, int face, List<Vec3> polygon, Plane plane) {}

    /** Returns all mirrors. */
    List<Mirror> mirrors() {
        List<Mirror> mirrors = new ArrayList<>();
        for (int solid = 0; solid < faces.length; solid++) {
            for (int face = 0; face < faces[solid].length; face++) {
                if (isMirror(solid, face)) {
                    List<Vec3> polygon = faces[solid][face].polygon;
                    mirrors.add(new Mirror(solid, face, polygon, Plane.through(normal(solid, face), polygon.get(0))));
                }
            }
        }
        return mirrors;
    }

    /** Returns the factor of a mirror on radiance, linear RGB. */
    Vec3 mirrorTint(int solid, int face) {
        return faces[solid][face].skin.material().baseColour();
    }

    /** Returns the outward unit normal of a face. */
    Vec3 normal(int solid, int face) {
        return Vec3.of(faces[solid][face].normal);
    }

    /** Returns the triangles of the emissive faces of a solid; a mirror is none, as paths never end on it. */
    EmissiveSurfaces.Triangles lit(int solid, TracedSolid shape) {
        List<int[]> fans = new ArrayList<>();
        for (int face = 0; face < faces[solid].length; face++) {
            boolean isLit = !isMirror(solid, face) && EmissiveSurfaces.brightness(emission(solid, face)) > 0;
            for (int i = 2; isLit && i < faces[solid][face].polygon.size(); i++) {
                fans.add(new int[] {face, 0, i - 1, i});
            }
        }
        return new EmissiveSurfaces.Triangles() {
            @Override
            public int count() {
                return fans.size();
            }

            @Override
            public Vec3 corner(int triangle, int corner) {
                int[] fan = fans.get(triangle);
                return faces[solid][fan[0]].polygon.get(fan[corner + 1]);
            }

            @Override
            public Vec3 radiance(int triangle, Vec3 place) {
                return emission(solid, fans.get(triangle)[0]);
            }

            @Override
            public int at(EyePath path) {
                int face = shape.face(path.ray());
                return IntStream.range(0, fans.size())
                        .filter(i -> fans.get(i)[0] == face)
                        .findFirst()
                        .orElseThrow();
            }
        };
    }

    private Vec3 emission(int solid, int face) {
        return faces[solid][face].skin.material().emission();
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

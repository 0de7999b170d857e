package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Vec3;
import nephele.engine.reference.Skins.Bare;
import nephele.engine.reference.Skins.Skin;
import nephele.engine.reference.Skins.Spot;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** What bodies are made of. A texture lies on a box as on a solid around the origin; round bodies show its s and t as such. */
final class BodySurfaces {
    private final List<Clothed> bodies;

    /** @param faces in the order of {@link nephele.engine.math.ConvexPolyhedron#box}; none for a round body */
    private record Clothed(Skin skin, List<FaceTexture> faces) {}

    BodySurfaces(List<Body> bodies, Skins skins) {
        this.bodies = bodies.stream()
                .map(body -> clothed(body, skins.skin(body.material())))
                .toList();
    }

    private static Clothed clothed(Body body, Skin skin) {
        if (!(body instanceof Body.Box box)) {
            return new Clothed(skin, List.of());
        }
        Solid solid = new Solid.Box(null, null, false, TextureMapping.WORLD, Vec3.ZERO, box.size(), java.util.Map.of());
        List<BrushFace> faces = Brush.of(solid).faces();
        return new Clothed(
                skin,
                faces.stream()
                        .map(face -> FaceTexture.of(face, skin.material().textureMetres()))
                        .toList());
    }

    /** @param toEye unit */
    SurfacePoint at(int item, BodyPiece piece, Vec3 place, Vector3dc toEye) {
        Clothed body = bodies.get(piece.body());
        Vector3d local = piece.local(place);
        Vector3d normal = piece.worldFromBody().transform(piece.form().normal(local));
        Spot spot = body.faces.isEmpty()
                ? new Spot(0, 0, normal, normal)
                : spot(body.faces.get(piece.form().face(local)), piece, local);
        return Skins.covered(new Bare(item, place, normal, toEye), body.skin, spot);
    }

    private static Spot spot(FaceTexture texture, BodyPiece piece, Vector3d local) {
        Vec3 p = Vec3.of(local);
        return new Spot(
                texture.s(p),
                texture.t(p),
                piece.worldFromBody().transform(texture.across().toVector()),
                piece.worldFromBody().transform(texture.up().toVector()));
    }
}

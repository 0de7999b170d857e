package nephele.engine.reference;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Vec3;
import nephele.engine.reference.MaterialTextures.Bare;
import nephele.engine.reference.MaterialTextures.Skin;
import nephele.engine.reference.MaterialTextures.Spot;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The materials of bodies. A box has its texture's middle in the middle of each face; a round body has a whole number
 * of repeats around it, and the middle at half its height. The twin of {@code dynamic.frag}.
 */
final class BodySurfaces {
    /** The material of each body. */
    private final List<Skin> skins;

    /** The textures of each body's faces in the order of {@link nephele.engine.math.ConvexPolyhedron#box}; none if it is round. */
    private final List<List<FaceTexture>> faces;

    BodySurfaces(List<Body> bodies, MaterialTextures textures) {
        skins = bodies.stream().map(body -> textures.skin(body.material())).toList();
        faces = bodies.stream()
                .map(body ->
                        faces(body, textures.skin(body.material()).material().textureMetres()))
                .toList();
    }

    private static List<FaceTexture> faces(Body body, double textureMetres) {
        if (!(body instanceof Body.Box box)) {
            return List.of();
        }
        Solid solid = new Solid.Box(null, null, false, TextureMapping.WORLD, Vec3.ZERO, box.size(), Map.of());
        return Brush.of(solid).faces().stream()
                .map(face -> FaceTexture.of(face, textureMetres))
                .toList();
    }

    /** Returns the radiance that a body emits. */
    Vec3 emission(int body) {
        return skins.get(body).material().emission();
    }

    /**
     * Returns a point of a body's surface.
     *
     * @param toEye unit
     */
    SurfacePoint at(int item, BodyPiece piece, Vec3 place, Vector3dc toEye) {
        Skin skin = skins.get(piece.body());
        List<FaceTexture> ofBody = faces.get(piece.body());
        Vector3d local = piece.local(place);
        Vector3d normal = piece.worldFromBody().transform(piece.form().normal(local));
        Spot spot = ofBody.isEmpty()
                ? aroundSpot(skin, (BodyShape.Capsule) piece.form(), piece, local)
                : faceSpot(ofBody.get(piece.form().face(local)), piece, local);
        return MaterialTextures.covered(new Bare(item, place, normal, toEye), skin, spot);
    }

    private static Spot faceSpot(FaceTexture texture, BodyPiece piece, Vector3d local) {
        Vec3 p = Vec3.of(local);
        return new Spot(
                texture.s(p) + 0.5,
                texture.t(p) + 0.5,
                piece.worldFromBody().transform(texture.across().toVector()),
                piece.worldFromBody().transform(texture.up().toVector()));
    }

    private static Spot aroundSpot(Skin skin, BodyShape.Capsule form, BodyPiece piece, Vector3d local) {
        double metres = skin.material().textureMetres();
        double turn = 2 * Math.PI * form.radius();
        double onAxis = Math.min(Math.max(local.y, -form.halfAxis()), form.halfAxis());
        double latitude = StrictMath.asin(Math.min(Math.max((local.y - onAxis) / form.radius(), -1), 1));
        double longitude = StrictMath.atan2(local.x, local.z) / (2 * Math.PI);
        double repeats = Math.max(1, Math.floor(turn / metres + 0.5));
        Vec3 n = Vec3.of(form.normal(local));
        Vec3 across = FaceTexture.across(n);
        return new Spot(
                (longitude < 0 ? longitude + 1 : longitude) * repeats,
                0.5 - (latitude * form.radius() + onAxis) / metres,
                piece.worldFromBody().transform(across.toVector()),
                piece.worldFromBody().transform(n.cross(across).toVector()));
    }
}

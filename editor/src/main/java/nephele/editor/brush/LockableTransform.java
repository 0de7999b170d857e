package nephele.editor.brush;

import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import nephele.editor.paint.PaintedFace;
import nephele.editor.paint.RigidMove;
import nephele.editor.paint.TextureFit;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;

/**
 * Moves and turns solids as {@link SolidTransform} does, with textures fixed to the faces or to the world.
 *
 * @param isTextureLocked true if the textures go with the faces
 * @param materials finds a material by its id; {@code null} for an unknown one
 */
public record LockableTransform(boolean isTextureLocked, Function<String, Material> materials) {
    /** Makes a transform for the materials of a level. */
    public static LockableTransform of(boolean isTextureLocked, List<Material> materials) {
        return new LockableTransform(isTextureLocked, id -> materials.stream()
                .filter(material -> material.id().equals(id))
                .findFirst()
                .orElse(null));
    }

    /** Returns the solid moved. */
    public Solid moved(Solid solid, Vec3 by) {
        return locked(solid, SolidTransform.moved(solid, by), RigidMove.shift(by));
    }

    /** Returns the solid turned around an axis through the pivot, counter-clockwise seen against the axis. */
    public BrushEdit<Solid> rotated(Solid solid, Vec3 pivot, Vec3 axis, double degrees) {
        RigidMove turn = new RigidMove(Rotations.aroundAxis(axis, Math.toRadians(degrees)), pivot, Vec3.ZERO);
        return SolidTransform.rotated(solid, pivot, axis, degrees).map(turned -> locked(solid, turned, turn));
    }

    private Solid locked(Solid before, Solid after, RigidMove move) {
        if (!isTextureLocked || after.equals(before)) {
            return after;
        }
        List<BrushFace> old = Brush.of(before).faces();
        Solid locked = after;
        for (BrushFace face : Brush.of(after).faces()) {
            BrushFace from = before(face, old, move);
            if (showsPicture(from)) {
                TexturePlacement placement = TextureFit.locked(painted(from), painted(face), move);
                Solid.Face authored = SolidFaces.authored(after, face.name());
                locked = SolidFaces.with(
                        locked, face.name(), new Solid.Face(authored.material(), authored.portalable(), placement));
            }
        }
        return locked;
    }

    /** Returns the face that has moved to a place: all faces of a convex solid have different normals. */
    private static BrushFace before(BrushFace after, List<BrushFace> old, RigidMove move) {
        Vec3 normal = after.plane().normal();
        return old.stream()
                .min(Comparator.comparingDouble(face ->
                        move.direction(face.plane().normal()).minus(normal).length()))
                .orElseThrow();
    }

    /** Plain faces get no placement, so that a level of theirs is not longer after each move. */
    private boolean showsPicture(BrushFace face) {
        Material material = material(face);
        boolean isPlain = material == null || material.texture() == null && material.normalTexture() == null;
        return !isPlain || face.texture() != null;
    }

    private PaintedFace painted(BrushFace face) {
        return PaintedFace.of(face, material(face));
    }

    private Material material(BrushFace face) {
        return face.material() == null ? null : materials.apply(face.material());
    }
}

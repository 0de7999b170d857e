package nephele.editor.tool;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.LevelShapes;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection.FaceRef;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/** Finds the faces of solids that the pointer touches; those of locked solids cannot be touched. */
public final class FacesUnderPointer {
    /** A drag is followed in steps of so many pixels, since the pointer may jump over a face between two events. */
    private static final double STEP_PIXELS = 6;

    private static final int MOST_STEPS = 32;

    private FacesUnderPointer() {}

    /** Returns the nearest visible face; empty if there is none or its solid is locked. */
    public static Optional<FaceRef> at(ToolContext context, Pointer pointer) {
        List<Picker.Pick> picks = context.picker().surfaces(pointer.ray());
        if (picks.isEmpty()) {
            return Optional.empty();
        }
        FaceRef face = new FaceRef(picks.get(0).entity(), picks.get(0).face());
        boolean isLocked = context.document()
                .level()
                .editor()
                .locked()
                .contains(face.solid().text());
        return isLocked ? Optional.empty() : Optional.of(face);
    }

    /** Returns the faces from one place of the pointer to the next, in order. */
    public static Set<FaceRef> between(ToolContext context, Pointer from, Pointer to) {
        double pixels = Math.hypot(to.x() - from.x(), to.y() - from.y());
        boolean isSameView = from.camera().equals(to.camera());
        int steps = isSameView ? (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(pixels / STEP_PIXELS))) : 1;
        Set<FaceRef> faces = new LinkedHashSet<>();
        for (int i = 1; i <= steps; i++) {
            double fraction = i / (double) steps;
            double x = from.x() + fraction * (to.x() - from.x());
            double y = from.y() + fraction * (to.y() - from.y());
            at(context, placed(to, x, y)).ifPresent(faces::add);
        }
        return faces;
    }

    private static Pointer placed(Pointer p, double x, double y) {
        return new Pointer(p.kind(), p.camera(), p.size(), x, y, p.modifiers(), p.clicks());
    }

    /** Returns the record of a face's solid. */
    public static Solid solid(Level level, FaceRef face) {
        return level.solids().stream()
                .filter(solid -> solid.id().equals(face.solid().id()))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the shape and look of a face; empty if it bounds nothing. */
    public static Optional<BrushFace> shape(Level level, FaceRef face) {
        return level.solids().stream()
                .filter(solid -> solid.id().equals(face.solid().id()))
                .flatMap(solid -> LevelShapes.brushOf(solid).stream())
                .flatMap(brush -> brush.faces().stream())
                .filter(side -> side.name().equals(face.face()))
                .findFirst();
    }
}

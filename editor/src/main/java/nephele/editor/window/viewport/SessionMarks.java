package nephele.editor.window.viewport;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.LevelShapes;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.pane.EntityMarks;
import nephele.editor.pane.Mark;
import nephele.editor.pane.Mark.Visibility;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Body;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Makes the marks of a session: symbols of entities, the selection, and what the tool shows. They are made on the drawing
 * thread, because those of models need their files.
 */
final class SessionMarks {
    private Marked of;
    private List<Mark> marks = List.of();
    private List<ModelPlacement> modelsOf = List.of();
    private AssetSource assetsOf;
    private PlacedModels models = PlacedModels.NONE;

    /** The state of a session that is marked. @param others the marks of the tool and of proofs */
    record Marked(Snapshot now, LevelShapes shapes, AssetSource assets, List<Mark> others) {
        /** Takes it on the session's thread. */
        static Marked of(EditorSession session) {
            List<Mark> others = new ArrayList<>(session.tool().marks());
            others.addAll(session.proving().marks());
            return new Marked(session.document().now(), session.context().shapes(), session.assets(), others);
        }

        private boolean isSame(Marked other) {
            return other != null && now.equals(other.now) && assets == other.assets;
        }
    }

    /** Returns all marks; those of the level are made anew only after an edit. */
    List<Mark> of(Marked marked) {
        if (!marked.isSame(of)) {
            marks = made(marked);
            of = marked;
        }
        List<Mark> all = new ArrayList<>(marks);
        all.addAll(marked.others());
        return all;
    }

    private List<Mark> made(Marked marked) {
        Level level = marked.now().level();
        LevelShapes shapes = marked.shapes();
        Selection selection = marked.now().selection();
        Set<String> names = selection.entities().stream().map(EntityRef::text).collect(Collectors.toSet());
        StaticShapes statics = new StaticShapes(shapes.brushes(), models(level, marked.assets()), List.of());
        List<Mark> made = new ArrayList<>(EntityMarks.of(level, statics, names));
        for (EntityRef ref : selection.entities()) {
            Entities.LEVEL.find(level, ref).ifPresent(entity -> addSelected(entity, shapes, made));
        }
        selection.faces().forEach(face -> addFace(face, level, shapes, made));
        return List.copyOf(made);
    }

    /** Returns the placed models; none if a file is missing, of which the drawing tells. */
    private PlacedModels models(Level level, AssetSource assets) {
        if (level.models() != modelsOf || assets != assetsOf) {
            modelsOf = level.models();
            assetsOf = assets;
            try {
                models = PlacedModels.of(level, assets);
            } catch (AssetException | IllegalArgumentException missing) {
                models = PlacedModels.NONE;
            }
        }
        return models;
    }

    private static void addSelected(Record entity, LevelShapes shapes, List<Mark> made) {
        if (entity instanceof Solid solid) {
            shapes.brush(solid).ifPresent(brush -> addEdges(brush, made));
        } else if (!(entity instanceof Body) && !(entity instanceof ModelPlacement)) {
            Aabb box = EntityBounds.of(entity);
            made.addAll(box.isEmpty() ? List.of() : Mark.box(box, MarkColour.SELECTED, Visibility.ALWAYS));
        }
    }

    private static void addEdges(Brush brush, List<Mark> made) {
        Set<Set<Vec3>> known = new HashSet<>();
        for (Brush.BrushFace face : brush.faces()) {
            addOutline(face.polygon(), known, made);
        }
    }

    private static void addOutline(List<Vec3> polygon, Set<Set<Vec3>> known, List<Mark> made) {
        for (int i = 0; i < polygon.size(); i++) {
            Vec3 from = polygon.get(i);
            Vec3 to = polygon.get((i + 1) % polygon.size());
            if (!from.equals(to) && known.add(Set.of(from, to))) {
                made.add(line(from, to));
            }
        }
    }

    private static Mark line(Vec3 from, Vec3 to) {
        return new Mark.Line(from, to, MarkColour.SELECTED, Visibility.ALWAYS);
    }

    private static void addFace(FaceRef ref, Level level, LevelShapes shapes, List<Mark> made) {
        Optional<Solid> solid = level.solids().stream()
                .filter(each -> each.id().equals(ref.solid().id()))
                .findFirst();
        List<Brush.BrushFace> faces =
                solid.flatMap(shapes::brush).map(Brush::faces).orElse(List.of());
        for (Brush.BrushFace face : faces) {
            if (face.name().equals(ref.face())) {
                made.add(new Mark.Polygon(face.polygon(), MarkColour.SELECTED, Visibility.HIDDEN_BY_SURFACES));
                addOutline(face.polygon(), new HashSet<>(), made);
            }
        }
    }
}

package nephele.editor.tool.portalable;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.FacesUnderPointer;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.appearance.SolidFaces;

/** Decides which faces take portals: a click changes a face, a drag makes all faces that it touches like the first. */
public final class PortalableTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "portalable",
            Words.of("Portalable faces", "Faces para portais", "Faces para portais"),
            Words.of(
                    "Click a face to permit or refuse portals on it; drag for more faces",
                    "Clique numa face para permitir ou recusar portais; arraste para mais faces",
                    "Clica numa face para permitir ou recusar portais; arrasta para mais faces"),
            "K",
            PortalableTool::new);

    private static final Words PERMIT = Words.of("Permit portals", "Permitir portais", "Permitir portais");
    private static final Words REFUSE = Words.of("Refuse portals", "Recusar portais", "Recusar portais");
    /** The areas are so far before their faces that these do not hide them. */
    private static final double LIFT_METRES = 5e-3;

    private final ToolContext context;
    private final Set<FaceRef> touched = new HashSet<>();
    /** The level with the faces changed so far; {@code null} without a stroke. */
    private Level changed;

    private Pointer previous;
    private boolean isPermitting;
    /** The solid under the pointer; {@code null} over nothing. */
    private EntityRef hovered;

    public PortalableTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = FacesUnderPointer.at(context, pointer).map(FaceRef::solid).orElse(null);
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        FacesUnderPointer.at(context, pointer).ifPresent(face -> {
            changed = context.document().level();
            isPermitting = !isPortalable(FacesUnderPointer.solid(changed, face), face.face());
            touched.clear();
            previous = pointer;
            dragged(pointer);
        });
    }

    private static boolean isPortalable(Solid solid, String face) {
        Boolean authored = SolidFaces.authored(solid, face).portalable();
        return authored == null ? solid.portalable() : authored;
    }

    @Override
    public void dragged(Pointer pointer) {
        if (changed == null) {
            return;
        }
        moved(pointer);
        Level before = changed;
        FacesUnderPointer.between(context, previous, pointer).stream()
                .filter(touched::add)
                .forEach(this::change);
        previous = pointer;
        if (changed != before) {
            Level now = changed;
            context.document().drag(start -> start.with(now));
        }
    }

    private void change(FaceRef face) {
        Solid solid = FacesUnderPointer.solid(changed, face);
        if (isPortalable(solid, face.face()) == isPermitting) {
            return;
        }
        Solid.Face authored = SolidFaces.authored(solid, face.face());
        Boolean wanted = solid.portalable() == isPermitting ? null : (Boolean) isPermitting;
        Solid other =
                SolidFaces.with(solid, face.face(), new Solid.Face(authored.material(), wanted, authored.texture()));
        changed = Entities.LEVEL.changed(changed, List.of(face.solid()), same -> (Record) other);
    }

    @Override
    public void released(Pointer pointer) {
        if (changed != null) {
            context.document().commitDrag(isPermitting ? PERMIT : REFUSE);
            changed = null;
        }
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        changed = null;
        hovered = null;
    }

    @Override
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>();
        Level level = context.document().level();
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        for (Brush brush : hovered == null ? List.<Brush>of() : context.shapes().brushes()) {
            if (brush.solidId().equals(hovered.id())) {
                brush.refusingPortalsOn(mirrors).faces().forEach(face -> marks.add(area(face)));
            }
        }
        return marks;
    }

    private static Mark area(BrushFace face) {
        return new Mark.Polygon(
                face.polygon().stream()
                        .map(corner ->
                                corner.addScaled(LIFT_METRES, face.plane().normal()))
                        .toList(),
                face.portalable() ? MarkColour.ALLOWED : MarkColour.REFUSED,
                Mark.Visibility.HIDDEN_BY_SURFACES);
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }
}

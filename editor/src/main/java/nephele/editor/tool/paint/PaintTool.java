package nephele.editor.tool.paint;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.paint.PaintedFace;
import nephele.editor.paint.TextureFit;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.record.Entities;
import nephele.editor.text.Words;
import nephele.editor.tool.FacesUnderPointer;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;

/**
 * Paints the faces that a click or a drag touches with the material of the options. Shift paints whole solids; Control
 * continues the picture from the face painted before; Alt takes the material of a face.
 */
public final class PaintTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "paint",
            Words.of("Paint", "Pintar", "Pintar"),
            Words.of(
                    "Click or drag over faces to paint; Shift: whole solid, Control: continue, Alt: pick",
                    "Pinte faces com clique ou arrasto; Shift: sólido, Control: continuar, Alt: pegar",
                    "Pinta faces com clique ou arrasto; Shift: sólido, Control: continuar, Alt: obter"),
            "M",
            PaintTool::new);

    private static final Words PAINT = Words.of("Paint", "Pintar", "Pintar");
    private static final Words TAKEN = Words.of("Material: %s", "Material: %s", "Material: %s");
    private static final Words GREY = Words.of("grey", "cinza", "cinzento");
    private static final Words UNKNOWN = Words.of(
            "There is no material %s: choose another one",
            "Não há o material %s: escolha outro", "Não há o material %s: escolhe outro");

    private final ToolContext context;
    private final Set<FaceRef> touched = new LinkedHashSet<>();
    /** The level with what is painted so far; {@code null} without a stroke. */
    private Level painted;

    private Pointer previous;
    /** The face painted last, in this stroke or before. */
    private FaceRef last;
    /** {@code last} as it was before the stroke. */
    private FaceRef lastBefore;
    /** {@code null} over nothing. */
    private FaceRef hovered;

    public PaintTool(ToolContext context) {
        this.context = context;
    }

    @Override
    public void moved(Pointer pointer) {
        hovered = FacesUnderPointer.at(context, pointer).orElse(null);
    }

    @Override
    public void left() {
        hovered = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moved(pointer);
        String material = context.options().material();
        if (pointer.isHeld(Modifier.ALT)) {
            take();
        } else if (material != null && material(material).isEmpty()) {
            context.status(UNKNOWN.with(material));
        } else {
            begin(pointer);
        }
    }

    private void begin(Pointer pointer) {
        painted = MaterialLibrary.STANDARD.including(
                context.document().level(), context.options().material());
        touched.clear();
        lastBefore = last;
        previous = pointer;
        dragged(pointer);
    }

    private void take() {
        if (hovered == null) {
            return;
        }
        FacesUnderPointer.shape(context.document().level(), hovered).ifPresent(face -> {
            context.options().material(face.material());
            context.status(TAKEN.with(face.material() == null ? GREY : face.material()));
        });
    }

    private Optional<Material> material(String id) {
        return MaterialLibrary.STANDARD.find(context.document().level(), id);
    }

    @Override
    public void dragged(Pointer pointer) {
        if (painted == null) {
            return;
        }
        moved(pointer);
        Level before = painted;
        for (FaceRef face : FacesUnderPointer.between(context, previous, pointer)) {
            if (touched.add(face)) {
                paint(face, pointer);
                last = face;
            }
        }
        previous = pointer;
        if (painted != before) {
            Level now = painted;
            context.document().drag(start -> start.with(now));
        }
    }

    private void paint(FaceRef face, Pointer pointer) {
        Solid solid = FacesUnderPointer.solid(painted, face);
        Solid changed = changed(solid, face, pointer);
        if (changed != solid) {
            painted = Entities.LEVEL.changed(painted, List.of(face.solid()), before -> (Record) changed);
        }
    }

    private Solid changed(Solid solid, FaceRef face, Pointer pointer) {
        String material = context.options().material();
        if (pointer.isHeld(Modifier.SHIFT)) {
            return whole(solid, material);
        }
        Optional<TexturePlacement> continued =
                pointer.isHeld(Modifier.CONTROL) ? continued(face, material) : Optional.empty();
        return continued
                .map(placement -> withFace(solid, face.face(), material, placement))
                .orElseGet(() -> withFace(solid, face.face(), material));
    }

    /** Returns the placement that continues the picture of the last face; empty if there is none. */
    private Optional<TexturePlacement> continued(FaceRef face, String material) {
        if (last == null || last.equals(face)) {
            return Optional.empty();
        }
        Optional<BrushFace> from = FacesUnderPointer.shape(painted, last);
        Optional<BrushFace> to = FacesUnderPointer.shape(painted, face);
        if (from.isEmpty() || to.isEmpty()) {
            return Optional.empty();
        }
        Material picture = material(material).orElse(null);
        return Optional.of(
                TextureFit.continued(PaintedFace.of(from.get(), picture), PaintedFace.of(to.get(), picture)));
    }

    @Override
    public void released(Pointer pointer) {
        if (painted == null) {
            return;
        }
        Snapshot after = new Snapshot(painted, touchedFaces());
        painted = null;
        if (context.document().isDragging()) {
            context.document().drag(start -> after);
            context.document().commitDrag(PAINT);
        } else if (!touched.isEmpty()) {
            context.document().select(after.selection());
        }
    }

    /** The faces just painted are selected, so that the buttons beside the tool's fit and align their picture. */
    private Selection touchedFaces() {
        return new Selection(List.of(), List.copyOf(touched));
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        if (painted != null) {
            painted = null;
            last = lastBefore;
        }
        hovered = null;
    }

    @Override
    public List<Mark> marks() {
        return Optional.ofNullable(hovered)
                .flatMap(face -> FacesUnderPointer.shape(context.document().level(), face))
                .map(face -> Mark.polygon(face.polygon(), MarkColour.PREVIEW, Mark.Visibility.ALWAYS))
                .orElse(List.of());
    }

    @Override
    public Words hint() {
        return ENTRY.description();
    }

    /** Returns the solid with a face of the material, {@code null} for grey; the same object if it has it already. */
    public static Solid withFace(Solid solid, String face, String material) {
        Solid.Face authored = SolidFaces.authored(solid, face);
        String now = authored.material() == null ? solid.material() : authored.material();
        return Objects.equals(now, material) ? solid : with(solid, face, material, authored.texture());
    }

    /** Returns the solid with a face of the material and another placement of its picture. */
    private static Solid withFace(Solid solid, String face, String material, TexturePlacement texture) {
        TexturePlacement placement = TexturePlacement.NONE.equals(texture) ? null : texture;
        boolean isSame = Objects.equals(SolidFaces.authored(solid, face).texture(), placement);
        return isSame ? withFace(solid, face, material) : with(solid, face, material, placement);
    }

    private static Solid with(Solid solid, String face, String material, TexturePlacement texture) {
        boolean isInherited = Objects.equals(solid.material(), material);
        // A face has no word for grey: the solid becomes grey, and its other faces keep their materials as their own.
        Solid base = material == null && !isInherited ? greyed(solid) : solid;
        return SolidFaces.with(
                base,
                face,
                new Solid.Face(
                        isInherited ? null : material,
                        SolidFaces.authored(solid, face).portalable(),
                        texture));
    }

    private static Solid greyed(Solid solid) {
        Solid grey = withMaterial(solid, null);
        for (String name : SolidFaces.names(solid)) {
            Solid.Face authored = SolidFaces.authored(solid, name);
            String material = authored.material() == null ? solid.material() : authored.material();
            grey = SolidFaces.with(grey, name, new Solid.Face(material, authored.portalable(), authored.texture()));
        }
        return grey;
    }

    /** Returns the solid with all of its faces of the material; the same object if they are. */
    private static Solid whole(Solid solid, String material) {
        Solid painted = withMaterial(solid, material);
        for (String name : SolidFaces.names(solid)) {
            Solid.Face authored = SolidFaces.authored(solid, name);
            if (authored.material() != null) {
                painted =
                        SolidFaces.with(painted, name, new Solid.Face(null, authored.portalable(), authored.texture()));
            }
        }
        return painted.equals(solid) ? solid : painted;
    }

    private static Solid withMaterial(Solid solid, String material) {
        return solid.with(solid.id(), material, solid.portalable(), solid.textureMapping());
    }
}

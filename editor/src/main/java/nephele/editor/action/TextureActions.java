package nephele.editor.action;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Document;
import nephele.editor.document.LevelShapes;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.paint.PaintedFace;
import nephele.editor.paint.TextureAlignment;
import nephele.editor.paint.TextureFit;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;

/** Placing the pictures on the selected faces, or on all faces of the selected solids. */
final class TextureActions {
    private static final double LEAST_REPEATS = 1e-3;
    private static final double MOST_REPEATS = 1e3;

    private static final Words PLACE = Words.of("Place Texture", "Posicionar textura", "Posicionar textura");
    private static final Words PICK = Words.of("Take Its Material", "Pegar o material", "Obter o material");
    private static final Words TAKEN = Words.of("Material: %s", "Material: %s", "Material: %s");
    private static final Words GREY = Words.of("default grey", "cinza padrão", "cinzento predefinido");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("texture-pick", PICK, Menu.BRUSH, List.of(), TextureActions::pick)
                    .when(TextureActions::hasFaces),
            EditorAction.of(
                            "texture-fit",
                            Words.of("Fit Texture", "Ajustar textura à face", "Ajustar textura à face"),
                            Menu.BRUSH,
                            List.of("Ctrl+Alt+F"),
                            TextureActions::fit)
                    .taking("across", "down")
                    .changing(Subject.LEVEL)
                    .when(TextureActions::hasFaces),
            aligned("left", Words.of("left", "à esquerda", "à esquerda"), TextureAlignment.LEFT),
            aligned("centre", Words.of("to the centre", "ao centro", "ao centro"), TextureAlignment.CENTRE),
            aligned("right", Words.of("right", "à direita", "à direita"), TextureAlignment.RIGHT),
            aligned("top", Words.of("to the top", "em cima", "em cima"), TextureAlignment.TOP),
            aligned("middle", Words.of("to the middle", "ao meio", "ao meio"), TextureAlignment.MIDDLE),
            aligned("bottom", Words.of("to the bottom", "embaixo", "em baixo"), TextureAlignment.BOTTOM),
            EditorAction.of(
                            "texture-reset",
                            Words.of("Reset Texture", "Restaurar textura", "Repor textura"),
                            Menu.BRUSH,
                            List.of(),
                            call -> place(call, face -> TexturePlacement.NONE))
                    .changing(Subject.LEVEL)
                    .when(TextureActions::hasFaces));

    private TextureActions() {}

    private static void fit(ActionCall call) throws EditorRefusal {
        double across = call.number("across", LEAST_REPEATS, MOST_REPEATS, 1);
        double down = call.number("down", LEAST_REPEATS, MOST_REPEATS, 1);
        place(call, face -> TextureFit.fit(face, across, down));
    }

    private static EditorAction aligned(String id, Words where, TextureAlignment alignment) {
        Words title = Words.of("Align Texture %s", "Alinhar textura %s", "Alinhar textura %s")
                .with(where);
        return EditorAction.of(
                        "texture-" + id,
                        title,
                        Menu.BRUSH,
                        List.of(),
                        call -> place(call, face -> TextureFit.align(face, alignment)))
                .changing(Subject.LEVEL)
                .when(TextureActions::hasFaces);
    }

    private static boolean hasFaces(EditorSession session) {
        return !faces(session.document()).isEmpty();
    }

    /** Returns the names of the faces by solid. */
    private static Map<EntityRef, Set<String>> faces(Document document) {
        Map<EntityRef, Set<String>> faces = new LinkedHashMap<>();
        List<EntityRef> selected =
                document.selection().faces().stream().map(FaceRef::solid).toList();
        List<EntityRef> free = NoteEdits.free(document.level(), selected);
        for (FaceRef face : document.selection().faces()) {
            if (!free.contains(face.solid())) {
                continue;
            }
            faces.computeIfAbsent(face.solid(), solid -> new LinkedHashSet<>()).add(face.face());
        }
        if (faces.isEmpty()) {
            for (EntityRef ref :
                    NoteEdits.free(document.level(), document.selection().entities())) {
                if (ref.section().equals(Picker.SOLIDS)) {
                    Entities.LEVEL
                            .find(document.level(), ref)
                            .ifPresent(solid -> faces.put(ref, new LinkedHashSet<>(SolidFaces.names((Solid) solid))));
                }
            }
        }
        return faces;
    }

    private static void place(ActionCall call, Function<PaintedFace, TexturePlacement> placing) {
        Document document = call.session().document();
        Level level = document.level();
        for (Map.Entry<EntityRef, Set<String>> each : faces(document).entrySet()) {
            Solid solid = (Solid) Entities.LEVEL.find(level, each.getKey()).orElseThrow();
            Solid placed = placed(level, solid, each.getValue(), placing);
            level = Entities.LEVEL.changed(level, List.of(each.getKey()), old -> (Record) placed);
        }
        Level after = level;
        document.edit(PLACE, null, before -> before.with(after));
    }

    private static Solid placed(
            Level level, Solid solid, Set<String> faces, Function<PaintedFace, TexturePlacement> placing) {
        Function<String, Material> materials = id -> level.materials().stream()
                .filter(material -> material.id().equals(id))
                .findFirst()
                .orElse(null);
        Solid result = solid;
        for (BrushFace face : brushFaces(solid)) {
            if (faces.contains(face.name())) {
                TexturePlacement placement = placing.apply(PaintedFace.of(face, materials.apply(face.material())));
                Solid.Face authored = SolidFaces.authored(result, face.name());
                result = SolidFaces.with(
                        result,
                        face.name(),
                        new Solid.Face(
                                authored.material(),
                                authored.portalable(),
                                TexturePlacement.NONE.equals(placement) ? null : placement));
            }
        }
        return result;
    }

    /** Returns none for a solid without volume, which shows no texture. */
    private static List<BrushFace> brushFaces(Solid solid) {
        return LevelShapes.brushOf(solid).map(Brush::faces).orElse(List.of());
    }

    private static void pick(ActionCall call) {
        EditorSession session = call.session();
        Map.Entry<EntityRef, Set<String>> first =
                faces(session.document()).entrySet().iterator().next();
        Solid solid = (Solid)
                Entities.LEVEL.find(session.document().level(), first.getKey()).orElseThrow();
        String material = brushFaces(solid).stream()
                .filter(face -> first.getValue().contains(face.name()))
                .findFirst()
                .map(BrushFace::material)
                .orElse(null);
        session.options().material(material);
        session.tell(SessionChange.VIEW);
        session.status(TAKEN.with(material == null ? GREY : material));
    }
}

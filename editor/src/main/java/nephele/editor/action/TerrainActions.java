package nephele.editor.action;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.terrain.LayerChoice;
import nephele.editor.terrain.TerrainBrush;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.terrain.TerrainPainting;
import nephele.editor.terrain.TerrainText;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.tool.terrain.TerrainTool;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;

/** The brush of the terrain tool, and strokes by numbers. */
final class TerrainActions {
    /** The factor of a step of radius or strength. */
    private static final double STEP = Math.sqrt(2);

    private static final Words RADIUS = Words.of("Brush radius: %s m", "Raio do pincel: %s m", "Raio do pincel: %s m");
    private static final Words STRENGTH =
            Words.of("Brush strength: %s %%", "Força do pincel: %s %%", "Força do pincel: %s %%");
    private static final Words NO_EFFECT = Words.of(
            "there is no effect '%s': raise, lower, smooth, flatten, paint, erase",
            "não há o efeito '%s': raise, lower, smooth, flatten, paint, erase",
            "não há o efeito '%s': raise, lower, smooth, flatten, paint, erase");
    private static final Words LAYER = Words.of("Layer: %s", "Camada: %s", "Camada: %s");
    private static final Words NO_LAYER =
            Words.of("there is no layer '%s': %s", "não há a camada '%s': %s", "não há a camada '%s': %s");
    private static final Words NO_TERRAIN =
            Words.of("there is no terrain '%s'", "não há o terreno '%s'", "não há o terreno '%s'");

    static final List<EditorAction> ALL = all();

    private TerrainActions() {}

    private static List<EditorAction> all() {
        List<EditorAction> all = new ArrayList<>();
        for (Effect effect : Effect.values()) {
            String id = "terrain-" + effect.name().toLowerCase(Locale.ROOT);
            all.add(EditorAction.of(id, effect.title(), Menu.TERRAIN, List.of(), call -> choose(call.session(), effect))
                    .chosenWhen(session -> session.options().terrainBrush().effect() == effect));
        }
        all.add(sized(
                "terrain-smaller",
                Words.of("Smaller Terrain Brush", "Pincel de terreno menor", "Pincel de terreno menor"),
                "Alt+OpenBracket",
                brush -> brush.ofRadius(brush.radiusMetres() / STEP)));
        all.add(sized(
                "terrain-larger",
                Words.of("Larger Terrain Brush", "Pincel de terreno maior", "Pincel de terreno maior"),
                "Alt+CloseBracket",
                brush -> brush.ofRadius(brush.radiusMetres() * STEP)));
        all.add(sized(
                "terrain-weaker",
                Words.of("Weaker Terrain Brush", "Pincel de terreno mais fraco", "Pincel de terreno mais fraco"),
                "Alt+Shift+OpenBracket",
                brush -> brush.ofStrength(brush.strength() / STEP)));
        all.add(sized(
                "terrain-stronger",
                Words.of("Stronger Terrain Brush", "Pincel de terreno mais forte", "Pincel de terreno mais forte"),
                "Alt+Shift+CloseBracket",
                brush -> brush.ofStrength(brush.strength() * STEP)));
        all.add(EditorAction.of(
                        "terrain-layer",
                        Words.of("Next Layer to Paint", "Próxima camada a pintar", "Camada seguinte a pintar"),
                        Menu.TERRAIN,
                        List.of(),
                        TerrainActions::layer)
                .taking("layer")
                .when(session -> LayerChoice.names(session.document().now()).size() > 1));
        all.add(EditorAction.of(
                        "terrain-stroke",
                        Words.of("Stroke on a Terrain", "Pincelada num terreno", "Pincelada num terreno"),
                        Menu.TERRAIN,
                        List.of(),
                        TerrainActions::stroke)
                .taking("effect", "layer", "from", "to", "radius", "strength", "terrain")
                .changing(Subject.LEVEL)
                .when(session -> !session.document().level().terrains().isEmpty()));
        return List.copyOf(all);
    }

    private static void choose(EditorSession session, Effect effect) {
        session.options().terrainBrush(session.options().terrainBrush().with(effect));
        if (session.toolEntry() != TerrainTool.ENTRY) {
            session.use(TerrainTool.ENTRY);
        }
        session.tell(SessionChange.VIEW);
    }

    private static EditorAction sized(String id, Words title, String key, UnaryOperator<TerrainBrush> change) {
        return EditorAction.of(id, title, Menu.TERRAIN, List.of(key), call -> {
            EditorSession session = call.session();
            TerrainBrush before = session.options().terrainBrush();
            TerrainBrush after = change.apply(before);
            session.options().terrainBrush(after);
            session.status(
                    after.strength() == before.strength()
                            ? RADIUS.with(TerrainText.number(after.radiusMetres()))
                            : STRENGTH.with(Math.round(100 * after.strength())));
            session.tell(SessionChange.VIEW);
        });
    }

    /** Chooses the layer that is named, without a name the next one, and painting. */
    private static void layer(ActionCall call) throws EditorRefusal {
        EditorSession session = call.session();
        List<String> names = LayerChoice.names(session.document().now());
        TerrainBrush before = session.options().terrainBrush();
        int next = call.text("layer").isPresent() ? layer(call, names, 0) : (before.layer() + 1) % names.size();
        session.options().terrainBrush(before.ofLayer(next));
        session.status(LAYER.with(names.get(next)));
        choose(session, Effect.PAINT);
    }

    private static int layer(ActionCall call, List<String> names, int absent) throws EditorRefusal {
        Optional<String> text = call.text("layer");
        return text.isEmpty()
                ? absent
                : LayerChoice.index(names, text.get())
                        .orElseThrow(() -> new EditorRefusal(NO_LAYER.with(text.get(), String.join(", ", names))));
    }

    /** Paints along a line; what is not given is that of the tool, the terrain the first one. */
    private static void stroke(ActionCall call) throws EditorRefusal {
        EditorSession session = call.session();
        TerrainBrush chosen = session.options().terrainBrush();
        Terrain terrain = terrain(call);
        TerrainBrush brush = new TerrainBrush(
                effect(call, chosen.effect()),
                call.number("radius", TerrainBrush.LEAST_METRES, TerrainBrush.MOST_METRES, chosen.radiusMetres()),
                call.number("strength", 0, 1, chosen.strength()),
                layer(call, LayerChoice.names(terrain), chosen.layer()));
        Vec3 from = call.vector("from");
        Vec3 to = call.vector("to", from);
        TerrainPainting painting = new TerrainPainting(session.document(), session.maps(), session.background());
        painting.begin(terrain, session.assets(), brush, from.x(), from.z());
        painting.to(to.x(), to.z());
        painting.notice().ifPresent(session::status);
        painting.end().ifPresent(session::status);
    }

    private static Effect effect(ActionCall call, Effect absent) throws EditorRefusal {
        Optional<String> named = call.text("effect");
        if (named.isEmpty()) {
            return absent;
        }
        return Arrays.stream(Effect.values())
                .filter(effect -> effect.name().toLowerCase(Locale.ROOT).equals(named.get()))
                .findFirst()
                .orElseThrow(() -> new EditorRefusal(NO_EFFECT.with(named.get())));
    }

    private static Terrain terrain(ActionCall call) throws EditorRefusal {
        List<Terrain> terrains = call.session().document().level().terrains();
        Optional<String> named = call.text("terrain");
        return terrains.stream()
                .filter(terrain -> named.isEmpty() || named.get().equals(terrain.id()))
                .findFirst()
                .orElseThrow(() -> new EditorRefusal(NO_TERRAIN.with(named.orElse(""))));
    }
}

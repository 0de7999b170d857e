package nephele.editor.panel;

import java.util.function.Consumer;
import java.util.function.Predicate;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.session.Tools;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** A step of the first room. Its state follows from the level alone, so undo takes it back. */
public enum GuideStep {
    ROOM(
            Words.of("Draw a room", "Desenhe uma sala", "Desenha uma sala"),
            Words.of(
                    "In the Top pane, drag a rectangle, such as 10 by 10 m. The wheel zooms, the middle button moves"
                            + " the view. Walls, floor and ceiling are made at once, 4 m high.",
                    "No painel Topo, arraste um retângulo, por exemplo de 10 por 10 m. A roda aproxima, o botão do meio"
                            + " move a vista. Paredes, piso e teto surgem de uma vez, com 4 m de altura.",
                    "No painel Topo, arrasta um retângulo, por exemplo de 10 por 10 m. A roda aproxima, o botão do meio"
                            + " move a vista. Paredes, chão e teto surgem de uma vez, com 4 m de altura."),
            session -> level(session).solids().size() >= 6,
            session -> {
                session.options().shape(new ShapeOptions.Room(0.5));
                use(session, "brush");
            }),
    LAMP(
            Words.of("Light it", "Ilumine", "Ilumina"),
            Words.of(
                    "You are inside now: hold the right button to look around, W A S D to fly. Click on the ceiling to"
                            + " hang a lamp. The inspector on the right sets its brightness and range.",
                    "Agora você está dentro: segure o botão direito para olhar, W A S D para voar. Clique no teto para"
                            + " pendurar uma lâmpada. O inspetor à direita muda brilho e alcance.",
                    "Agora estás lá dentro: mantém o botão direito premido para olhar, W A S D para voar. Clica no teto"
                            + " para pendurar uma lâmpada. O inspetor à direita muda brilho e alcance."),
            session -> !level(session).lights().isEmpty(),
            session -> {
                inside(session, 25);
                place(session, "lights", "point");
            }),
    START(
            Words.of("Start and exit", "Início e saída", "Início e saída"),
            Words.of(
                    "Click on the floor to place the start. Then choose Exit under Add and click on the floor at the"
                            + " other end of the room.",
                    "Clique no piso para colocar o início. Depois escolha Saída em Adicionar e clique no piso do outro"
                            + " lado da sala.",
                    "Clica no chão para colocar o início. Depois escolhe Saída em Adicionar e clica no chão do outro"
                            + " lado da sala."),
            session ->
                    level(session).player() != null && !level(session).exits().isEmpty(),
            session -> {
                inside(session, -28);
                boolean needsExit = level(session).player() != null;
                place(session, needsExit ? "exits" : "player", needsExit ? "exit" : "playerstart");
            }),
    THINGS(
            Words.of("A cube and a cloud", "Um cubo e uma nuvem", "Um cubo e uma nuvem"),
            Words.of(
                    "Click on the floor to place a cube that can be carried. Then choose Cloud under Add and"
                            + " click again: a cloud appears 60 m above.",
                    "Clique no piso para colocar um cubo que se pode carregar. Depois escolha Nuvem em"
                            + " Adicionar e clique de novo: uma nuvem aparece 60 m acima.",
                    "Clica no chão para colocar um cubo que se pode carregar. Depois escolhe Nuvem em"
                            + " Adicionar e clica de novo: uma nuvem aparece 60 m acima."),
            session -> !level(session).bodies().isEmpty()
                    && !level(session).environment().clouds().isEmpty(),
            session -> {
                inside(session, -28);
                boolean needsCloud = !level(session).bodies().isEmpty();
                place(session, needsCloud ? "environment.clouds" : "bodies", "box");
            }),
    PORTALS(
            Words.of("Two portals", "Dois portais", "Dois portais"),
            Words.of(
                    "Click on a wall, then on another one: the two portals are linked. The outline slides to where"
                            + " there is room, as in the game.",
                    "Clique numa parede, depois em outra: os dois portais ficam ligados. O contorno desliza até onde há"
                            + " espaço, como no jogo.",
                    "Clica numa parede, depois noutra: os dois portais ficam ligados. O contorno desliza até onde há"
                            + " espaço, como no jogo."),
            session -> hasLinkedPortals(level(session)),
            session -> {
                inside(session, -5);
                use(session, "portal");
            }),
    PLAY(
            Words.of("Save and play", "Salve e jogue", "Guarda e joga"),
            Words.of(
                    "Problems below should be empty. Save with Ctrl+S, then press F5 to play from here, Shift+F5 from"
                            + " the start; Esc comes back.",
                    "Problemas, embaixo, deve estar vazio. Salve com Ctrl+S e pressione F5 para jogar daqui, Shift+F5"
                            + " do início; Esc volta.",
                    "Problemas, em baixo, deve estar vazio. Guarda com Ctrl+S e prime F5 para jogar daqui, Shift+F5 do"
                            + " início; Esc volta."),
            session -> session.file().path().isPresent() && !session.document().isModified(),
            session -> use(session, "select"));

    private final Words title;
    private final Words text;
    private final Predicate<EditorSession> isDone;
    private final Consumer<EditorSession> preparation;

    GuideStep(Words title, Words text, Predicate<EditorSession> isDone, Consumer<EditorSession> preparation) {
        this.title = title;
        this.text = text;
        this.isDone = isDone;
        this.preparation = preparation;
    }

    public Words title() {
        return title;
    }

    /** Returns what the user is asked to do. */
    public Words text() {
        return text;
    }

    /** Returns true if the level has what the step asks for. */
    public boolean isDone(EditorSession session) {
        return isDone.test(session);
    }

    /** Takes the tool that the step needs and turns the view to where it is used. */
    public void prepare(EditorSession session) {
        session.document().select(Selection.NONE);
        preparation.accept(session);
        session.tell(SessionChange.VIEW);
    }

    private static Level level(EditorSession session) {
        return session.document().level();
    }

    private static boolean hasLinkedPortals(Level level) {
        return level.portals().stream().anyMatch(portal -> isLinked(portal, level));
    }

    private static boolean isLinked(PortalSpec portal, Level level) {
        return !portal.linkedTo().equals(portal.id())
                && level.portals().stream().anyMatch(other -> other.id().equals(portal.linkedTo()));
    }

    private static void place(EditorSession session, String section, String kind) {
        session.options().entity(section, kind);
        use(session, "place");
    }

    private static void use(EditorSession session, String tool) {
        Tools.named(tool).ifPresent(session::use);
    }

    private static final double FOV_DEGREES = 75;

    /** Places the camera in the room, near its south wall, looking north. */
    private static void inside(EditorSession session, double pitchDegrees) {
        Aabb room = Aabb.EMPTY;
        for (Solid solid : session.document().level().solids()) {
            room = room.union(EntityBounds.of((Record) solid));
        }
        if (room.isEmpty()) {
            return;
        }
        Vec3 middle = room.centre();
        double south = room.maxZ() - 0.18 * (room.maxZ() - room.minZ());
        var camera = new PerspectiveCamera(
                new Vec3(middle.x(), Math.min(middle.y(), room.minY() + 2.4), south), 0, pitchDegrees, FOV_DEGREES);
        session.panes(panes -> {
            PaneLayout result = panes;
            for (int i = 0; i < panes.views().size(); i++) {
                PaneView view = panes.views().get(i);
                if (view.kind() == PaneKind.PERSPECTIVE) {
                    result = result.with(i, view.with(camera)).withActive(i);
                }
            }
            return result;
        });
    }
}

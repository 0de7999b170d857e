package nephele.editor.window.viewport;

import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.ViewMode;
import nephele.editor.text.Words;

/** The captions of panes. */
final class PaneCaption {
    private PaneCaption() {}

    static Words of(PaneView view) {
        return view.kind() == PaneKind.PERSPECTIVE ? of(view.mode()) : of(view.kind());
    }

    private static Words of(PaneKind kind) {
        return switch (kind) {
            case PERSPECTIVE -> Words.of("Perspective", "Perspectiva", "Perspetiva");
            case TOP -> Words.of("Top", "Topo", "Topo");
            case FRONT -> Words.of("Front", "Frente", "Frente");
            case SIDE -> Words.of("Side", "Lado", "Lado");
        };
    }

    private static Words of(ViewMode mode) {
        return switch (mode) {
            case LIT -> Words.of("Perspective, lit", "Perspectiva, iluminada", "Perspetiva, iluminada");
            case UNLIT -> Words.of("Perspective, unlit", "Perspectiva, sem luz", "Perspetiva, sem luz");
            case PORTALABLE -> Words.of("Perspective, portalable", "Perspectiva, portais", "Perspetiva, portais");
            case COLLISION -> Words.of("Perspective, collision", "Perspectiva, colisão", "Perspetiva, colisão");
            case WIREFRAME -> Words.of("Perspective, edges", "Perspectiva, arestas", "Perspetiva, arestas");
        };
    }
}

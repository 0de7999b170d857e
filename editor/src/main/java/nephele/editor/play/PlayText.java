package nephele.editor.play;

import java.util.Locale;
import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of play and solutions in English, Brazilian and European Portuguese. */
public enum PlayText implements Text {
    STARTING("Starting the game …", "Abrindo o jogo …", "A abrir o jogo …"),
    PLAYING(
            "Playing; Esc in the game comes back here",
            "Jogando; Esc no jogo volta para cá",
            "A jogar; Esc no jogo volta para aqui"),
    BAKING("Baking the light: %s %%", "Calculando a luz: %s %%", "A calcular a luz: %s %%"),
    ENDED("Back from the game", "De volta do jogo", "De volta do jogo"),
    EXIT_REACHED(
            "Exit reached after %s s with %s portals",
            "Saída alcançada após %s s com %s portais", "Saída alcançada ao fim de %s s com %s portais"),
    RECORDED("Solution recorded: %s", "Solução gravada: %s", "Solução gravada: %s"),
    NOT_RECORDED(
            "No solution was recorded: the exit was not reached. F6 tries again.",
            "Nenhuma solução foi gravada: a saída não foi alcançada. F6 tenta de novo.",
            "Não foi gravada nenhuma solução: a saída não foi alcançada. F6 tenta outra vez."),
    CHECKING("Replaying the solution: %s %%", "Repetindo a solução: %s %%", "A repetir a solução: %s %%"),
    SOLVED(
            "Solved at tick %s, after %s s with %s portals",
            "Resolvido no tique %s, após %s s com %s portais", "Resolvido no tique %s, ao fim de %s s com %s portais"),
    STRAYS_AT_FIRST(
            "first astray at tick %s, %s s: %s",
            "primeiro desvio no tique %s, aos %s s: %s", "primeiro desvio no tique %s, aos %s s: %s"),
    NOT_SOLVED("Not solved", "Não resolvido", "Não resolvido"),
    ELSEWHERE(
            "the player is %s m from the recorded place",
            "o jogador está a %s m do lugar gravado", "o jogador está a %s m do lugar gravado"),
    PORTAL_REFUSED(
            "a shot places no portal that placed one",
            "um tiro que abria um portal já não o abre",
            "um tiro que abria um portal já não o abre"),
    EXIT_NOT_REACHED(
            "the recording ends before the exit",
            "a gravação termina antes da saída",
            "a gravação termina antes da saída");

    private final Words words;

    PlayText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }

    /** Returns the sentence for a play that has ended. */
    public static Words of(PlayEnd end) {
        if (end.recorded() != null) {
            return RECORDED.with(end.recorded());
        }
        return end.exitReached() ? EXIT_REACHED.with(number(end.exitSeconds()), end.portals()) : ENDED.words;
    }

    /** Returns the sentence for a play that was to record a solution and has ended. */
    public static Words ofRecording(PlayEnd end) {
        return end.recorded() == null && !end.exitReached() ? NOT_RECORDED.words : of(end);
    }

    /** Returns the sentence for a verdict. */
    public static Words of(SolutionVerdict verdict) {
        Words result = verdict.exit()
                .map(exit -> SOLVED.with(exit.tick(), number(exit.seconds()), exit.portals()))
                .orElse(NOT_SOLVED.words);
        return verdict.deviation()
                .map(first -> Words.same("%s; %s")
                        .with(result, STRAYS_AT_FIRST.with(first.tick(), number(first.seconds()), cause(first))))
                .orElse(result);
    }

    private static Words cause(SolutionVerdict.Deviation deviation) {
        return switch (deviation.cause()) {
            case ELSEWHERE ->
                ELSEWHERE.with(
                        number(deviation.place().minus(deviation.expected()).length()));
            case PORTAL_REFUSED -> PORTAL_REFUSED.words;
            case EXIT_NOT_REACHED -> EXIT_NOT_REACHED.words;
        };
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}

package nephele.editor.terrain;

import nephele.editor.text.Words;

/** What painting a terrain tells its user. */
public enum TerrainText {
    SAVE_FIRST(
            "Save the level first: painted heights are files in its folder",
            "Salve a fase antes: os relevos pintados são arquivos na pasta dela",
            "Guarda o nível primeiro: os relevos pintados são ficheiros na pasta dele"),
    NO_TERRAIN(
            "There is no terrain here: Add has one",
            "Não há terreno aqui: Adicionar tem um",
            "Não há terreno aqui: Adicionar tem um"),
    LOCKED("The terrain %s is locked", "O terreno %s está travado", "O terreno %s está bloqueado"),
    NO_RANGE(
            "The terrain %s can only be flat: give it a range of heights",
            "O terreno %s só pode ser plano: dê a ele uma faixa de alturas",
            "O terreno %s só pode ser plano: dá-lhe um intervalo de alturas"),
    AT_LIMIT(
            "Heights of this terrain end at %s m and %s m: its range can be changed",
            "As alturas deste terreno vão de %s m a %s m: a faixa pode ser mudada",
            "As alturas deste terreno vão de %s m a %s m: o intervalo pode ser mudado"),
    NOT_KEPT("The stroke is lost: %s", "A pincelada se perdeu: %s", "A pincelada perdeu-se: %s"),
    UNUSABLE("It can't be painted: %s", "Não pode ser pintado: %s", "Não pode ser pintado: %s"),
    BRUSH(
            "%s: radius %s m, strength %s %%, height %s m",
            "%s: raio %s m, força %s %%, altura %s m", "%s: raio %s m, força %s %%, altura %s m");

    private final Words words;

    TerrainText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    public Words words() {
        return words;
    }

    /** Returns the text with its {@code %s} replaced. */
    public Words with(Object... values) {
        return words.with(values);
    }
}

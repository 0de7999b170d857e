package nephele.app.text;

import java.util.Locale;
import nephele.engine.level.Language;

/** A text of the game in English, Brazilian and European Portuguese. */
public enum Phrase {
    CONTINUE("Continue", "Continuar", "Continuar"),
    BEGIN("Begin", "Começar", "Começar"),
    LEVELS("Levels", "Fases", "Níveis"),
    SETTINGS("Settings", "Configurações", "Definições"),
    QUIT("Quit", "Sair", "Sair"),
    RESTART("Restart", "Recomeçar", "Recomeçar"),
    RESTART_QUESTION("Restart this level?", "Recomeçar esta fase?", "Recomeçar este nível?"),
    RESTART_LOSS(
            "What you have done in it is lost.", "O que você fez nela será perdido.", "O que fizeste nele perde-se."),
    TO_TITLE("To the title", "Ir para o início", "Ir para o início"),
    BACK("Back", "Voltar", "Voltar"),
    PAUSED("Paused", "Pausa", "Pausa"),
    NEXT_LEVEL("Next level", "Próxima fase", "Próximo nível"),
    AGAIN("Play again", "Jogar de novo", "Jogar de novo"),
    LEVEL_DONE("Done", "Concluída", "Concluído"),
    TIME("Time", "Tempo", "Tempo"),
    BEST("Best", "Melhor", "Melhor"),
    NEW_BEST("New best", "Novo recorde", "Novo recorde"),
    UNRANKED("Practice: no record is kept.", "Treino: nenhum recorde é salvo.", "Treino: nenhum recorde é guardado."),
    PORTALS("Portals", "Portais", "Portais"),
    ALL_DONE("You have finished every level.", "Você concluiu todas as fases.", "Concluíste todos os níveis."),
    NOT_YET("not yet", "ainda não", "ainda não"),
    LOADING("Loading", "Carregando", "A carregar"),
    READING("reading the level", "lendo a fase", "a ler o nível"),
    BAKING("baking its light: %s %%", "calculando a luz: %s %%", "a calcular a luz: %s %%"),
    PREPARING("preparing the picture", "preparando a imagem", "a preparar a imagem"),
    BOUNDS_SPHERE("Bounding sphere", "Esfera envolvente", "Esfera envolvente"),
    BOUNDS_BOX("Axis-aligned box", "Caixa alinhada aos eixos", "Caixa alinhada aos eixos"),
    BOUNDS_ORIENTED_BOX("Oriented box", "Caixa orientada", "Caixa orientada"),
    BOUNDS_TREE("Tree of boxes", "Árvore de caixas", "Árvore de caixas"),
    BOUNDS_TRIANGLES("Triangles", "Triângulos", "Triângulos"),
    BOUNDS_TOUCHED("contact", "contato", "contacto"),
    BOUNDS_APART("no contact", "sem contato", "sem contacto"),
    BOUNDS_NEXT("next bounds", "próximo volume", "volume seguinte"),
    OBSERVER_MOVES("move the sphere", "mover a esfera", "mover a esfera"),
    REPLAY_OVER("The replay is over", "A gravação terminou", "A gravação terminou"),
    TAKEN_OVER("You are in control", "O controle é seu", "O controlo é teu"),
    EXIT_REACHED("Exit reached", "Saída alcançada", "Saída alcançada"),
    SLOW(
            "Fewer than four frames a second: time runs slower.",
            "Menos de quatro quadros por segundo: o tempo passa mais devagar.",
            "Menos de quatro imagens por segundo: o tempo passa mais devagar."),
    ADVICE_QUALITY(
            "Lower the quality in the settings.",
            "Reduza a qualidade nas configurações.",
            "Reduz a qualidade nas definições."),
    ADVICE_QUALITY_AT_START(
            "Start again with a lower quality.",
            "Comece de novo com qualidade mais baixa.",
            "Começa de novo com qualidade mais baixa."),
    ADVICE_RESOLUTION(
            "Choose a smaller resolution in the settings.",
            "Escolha uma resolução menor nas configurações.",
            "Escolhe uma resolução menor nas definições."),
    ADVICE_OTHER_WINDOW(
            "Choose a window or full screen and a smaller resolution in the settings.",
            "Escolha janela ou tela cheia e uma resolução menor nas configurações.",
            "Escolhe janela ou ecrã inteiro e uma resolução menor nas definições."),
    QUALITY_ADAPTS("The quality adapts.", "A qualidade está se adaptando.", "A qualidade está a adaptar-se."),
    MENU_KEYS("↑ ↓  Enter  or mouse", "↑ ↓  Enter  ou mouse", "↑ ↓  Enter  ou rato"),
    PAD_MENU_KEYS("↑ ↓  A  choose", "↑ ↓  A  escolher", "↑ ↓  A  escolher"),
    FOOT_BACK("back", "voltar", "voltar"),
    FOOT_CONTINUE("continue", "continuar", "continuar"),
    FROM_NEXT_START("Holds from the next start", "Vale a partir do próximo início", "Vale a partir do próximo início"),
    NO_PORTAL("No portal: %s", "Sem portal: %s", "Sem portal: %s"),
    REFUSED_NOTHING_HIT("nothing is there", "não há nada ali", "não há nada ali"),
    REFUSED_OUT_OF_RANGE("too far away", "longe demais", "demasiado longe"),
    REFUSED_MOVING_SURFACE(
            "something that moves is in the way",
            "algo que se move está no caminho",
            "algo que se move está no caminho"),
    REFUSED_NOT_PORTALABLE(
            "this surface takes none", "esta superfície não aceita portais", "esta superfície não aceita portais"),
    REFUSED_NOT_FLAT(
            "the ground is uneven by %s mm here, allowed are 10",
            "o chão tem %s mm de desnível aqui, são permitidos 10",
            "o chão tem %s mm de desnível aqui, são permitidos 10"),
    REFUSED_OVERLAPS_OTHER(
            "the other portal is in its place", "o outro portal está no lugar", "o outro portal está no lugar"),
    REFUSED_TOO_SMALL("the surface is too small", "a superfície é pequena demais", "a superfície é demasiado pequena"),
    REFUSED_EDGE("too near the edge", "perto demais da borda", "demasiado perto da borda"),
    REFUSED_OCCUPIED(
            "something stands in the old one and has no room",
            "algo está no portal antigo e não tem espaço",
            "algo está no portal antigo e não tem espaço"),
    TOO_HEAVY("Too heavy", "Pesado demais", "Demasiado pesado"),
    LOST("Let go: nothing leads to it any more", "Solto: nada mais leva até ele", "Largado: já nada leva até ele"),
    RETURNED(
            "It fell far: it is back in its place",
            "Caiu longe: voltou ao seu lugar",
            "Caiu longe: voltou ao seu lugar"),
    SAVED("Saved %s", "Salvo em %s", "Guardado em %s"),
    RECORDED("Recorded %s", "Gravado em %s", "Gravado em %s"),
    NOT_LOADED(
            "The level cannot be loaded: %s",
            "A fase não pode ser carregada: %s", "O nível não pode ser carregado: %s"),
    SETTING_LANGUAGE("Language", "Idioma", "Idioma"),
    SETTING_HORIZONTAL_FOV_DEGREES("Field of view", "Campo de visão", "Campo de visão"),
    SETTING_MOUSE_SPEED("Mouse speed", "Velocidade do mouse", "Velocidade do rato"),
    SETTING_INVERT_MOUSE("Invert mouse", "Inverter mouse", "Inverter rato"),
    SETTING_CROUCH("Crouch", "Agachar", "Agachar"),
    SETTING_QUALITY("Quality", "Qualidade", "Qualidade"),
    SETTING_AUTO_FRAME_RATE("Auto: frames/s", "Auto: quadros/s", "Auto: imagens/s"),
    SETTING_WINDOW_MODE("Window", "Janela", "Janela"),
    SETTING_RESOLUTION("Resolution", "Resolução", "Resolução"),
    SETTING_EDGE_FILTER("Smooth edges", "Suavizar bordas", "Suavizar arestas"),
    SETTING_VERTICAL_SYNC("Vertical sync", "Sincronia vertical", "Sincronização vertical"),
    SETTING_FRAME_CAP("Frame cap", "Limite de quadros", "Limite de imagens"),
    SETTING_ASSISTS("Aids", "Ajudas", "Ajudas"),
    SETTING_UPRIGHT_SPEED("Turning upright", "Endireitar-se", "Endireitar-se"),
    SETTING_REDUCED_MOTION("Reduced motion", "Movimento reduzido", "Movimento reduzido"),
    SETTING_REDUCED_FLASHES("Soft lightning", "Relâmpagos suaves", "Relâmpagos suaves"),
    SETTING_PORTAL_COLOURS("Portal colours", "Cores dos portais", "Cores dos portais"),
    WORD_BLUE_ORANGE("blue, orange", "azul, laranja", "azul, laranja"),
    WORD_BLUE_YELLOW("blue, yellow", "azul, amarelo", "azul, amarelo"),
    WORD_CYAN_RED("cyan, red", "ciano, vermelho", "ciano, vermelho"),
    WORD_WHITE_MAGENTA("white, magenta", "branco, magenta", "branco, magenta"),
    CONTROL_FORWARD("walk forward", "andar para a frente", "andar para a frente"),
    CONTROL_BACK("walk back", "andar para trás", "andar para trás"),
    CONTROL_LEFT("walk left", "andar para a esquerda", "andar para a esquerda"),
    CONTROL_RIGHT("walk right", "andar para a direita", "andar para a direita"),
    CONTROL_RUN("run", "correr", "correr"),
    CONTROL_JUMP("jump", "pular", "saltar"),
    CONTROL_CROUCH("crouch", "agachar", "agachar"),
    CONTROL_FIRE_FIRST("first portal; throw", "primeiro portal; jogar", "primeiro portal; atirar"),
    CONTROL_FIRE_SECOND("second portal", "segundo portal", "segundo portal"),
    CONTROL_CARRY("pick up, let go", "pegar, soltar", "agarrar, largar"),
    CONTROL_THROW("throw", "jogar", "atirar"),
    CONTROL_PERSON("first or third person", "primeira ou terceira pessoa", "primeira ou terceira pessoa"),
    CONTROL_GOAL("show the goal", "mostrar o objetivo", "mostrar o objetivo"),
    CONTROL_HINT("a hint", "uma dica", "uma pista"),
    CONTROL_RESTART("start again", "recomeçar", "recomeçar"),
    CONTROL_MENU("menu", "menu", "menu"),
    CONTROL_CONFIRM("choose", "escolher", "escolher"),
    CONTROL_HELP("this page", "esta página", "esta página"),
    CONTROL_FIGURES("figures", "números", "números"),
    CONTROL_FULL_SCREEN("full screen", "tela cheia", "ecrã inteiro"),
    CONTROL_SCREENSHOT("picture (%s: bare)", "imagem (%s: sem textos)", "imagem (%s: sem textos)"),
    DIFFERS(
            "%s differs from %s by FLIP %s, mean light %s %%",
            "%s difere de %s por FLIP %s, luz média %s %%", "%s difere de %s por FLIP %s, luz média %s %%"),
    NO_DIFFERENCE("The two pictures do not differ", "As duas imagens não diferem", "As duas imagens não diferem"),
    MOVE_WIPE("move the wipe (%s: finely)", "mover a divisória (%s: devagar)", "mover a divisória (%s: devagar)"),
    WHOLE_SIDE("only the right, the left picture", "só a imagem direita, esquerda", "só a imagem direita, esquerda"),
    KEYS("Keys", "Teclas", "Teclas"),
    LOOK("look around", "olhar em volta", "olhar em volta"),
    MOUSE("Mouse", "Mouse", "Rato"),
    PRESS_KEY("press a key", "pressione uma tecla", "prime uma tecla"),
    NO_KEY("none", "nenhuma", "nenhuma"),
    ALSO("also: %s", "também: %s", "também: %s"),
    UNNAMED_KEY("This key cannot be used", "Esta tecla não pode ser usada", "Esta tecla não pode ser usada"),
    PROMPT_PICK_UP("pick up", "pegar", "agarrar"),
    PROMPT_THROW("throw", "jogar", "atirar"),
    PROMPT_FIRST("open the first portal", "abrir o primeiro portal", "abrir o primeiro portal"),
    PROMPT_SECOND("open the second portal", "abrir o segundo portal", "abrir o segundo portal"),
    PROMPT_WALK("walk", "andar", "andar"),
    GOAL("Goal", "Objetivo", "Objetivo"),
    NO_GOAL("This level says no goal.", "Esta fase não diz o objetivo.", "Este nível não diz o objetivo."),
    HINT_OFFERED("%s: a hint, if you are stuck", "%s: uma dica, se você travou", "%s: uma pista, se não avanças"),
    HINT_GIVEN("Hint %s of %s: %s", "Dica %s de %s: %s", "Pista %s de %s: %s"),
    NO_HINT_YET(
            "No hint yet: try for a while",
            "Ainda sem dica: tente mais um pouco",
            "Ainda sem pista: tenta mais um pouco"),
    NO_HINTS("This level has no hints", "Esta fase não tem dicas", "Este nível não tem pistas"),
    HINTS("Hints", "Dicas", "Pistas"),
    KEY_SPACE("Space", "Espaço", "Espaço"),
    KEY_ESCAPE("Esc", "Esc", "Esc"),
    KEY_ENTER("Enter", "Enter", "Enter"),
    KEY_TAB("Tab", "Tab", "Tab"),
    KEY_BACKSPACE("Backspace", "Backspace", "Retrocesso"),
    KEY_INSERT("Insert", "Insert", "Insert"),
    KEY_DELETE("Delete", "Delete", "Delete"),
    KEY_RIGHT("→", "→", "→"),
    KEY_LEFT("←", "←", "←"),
    KEY_DOWN("↓", "↓", "↓"),
    KEY_UP("↑", "↑", "↑"),
    KEY_PAGE_UP("Page Up", "Page Up", "Page Up"),
    KEY_PAGE_DOWN("Page Down", "Page Down", "Page Down"),
    KEY_HOME("Home", "Home", "Home"),
    KEY_END("End", "End", "End"),
    KEY_LEFT_SHIFT("Left Shift", "Shift esq.", "Shift esq."),
    KEY_RIGHT_SHIFT("Right Shift", "Shift dir.", "Shift dir."),
    KEY_LEFT_CTRL("Left Ctrl", "Ctrl esq.", "Ctrl esq."),
    KEY_RIGHT_CTRL("Right Ctrl", "Ctrl dir.", "Ctrl dir."),
    KEY_LEFT_ALT("Left Alt", "Alt esq.", "Alt esq."),
    KEY_RIGHT_ALT("Right Alt", "Alt dir.", "Alt dir."),
    KEY_KEYPAD("Keypad %s", "Num %s", "Num %s"),
    KEY_MOUSE("Mouse %s", "Mouse %s", "Rato %s"),
    LEFT_CLICK("left click", "clique esquerdo", "clique esquerdo"),
    RIGHT_CLICK("right click", "clique direito", "clique direito"),
    WORD_OFF("off", "não", "não"),
    WORD_ON("on", "sim", "sim"),
    WORD_HOLD("hold", "segurar", "manter"),
    WORD_TOGGLE("toggle", "alternar", "alternar"),
    WORD_LOW("low", "baixa", "baixa"),
    WORD_MEDIUM("medium", "média", "média"),
    WORD_HIGH("high", "alta", "alta"),
    WORD_ULTRA("ultra", "ultra", "ultra"),
    WORD_AUTO("auto", "automática", "automática"),
    WORD_WINDOWED("window", "janela", "janela"),
    WORD_BORDERLESS("borderless", "sem moldura", "sem moldura"),
    WORD_FULLSCREEN("full screen", "tela cheia", "ecrã inteiro"),
    WORD_NONE("none", "nenhuma", "nenhuma"),
    WORD_USUAL("usual", "usuais", "habituais"),
    WORD_ALL("all", "todas", "todas"),
    WORD_SLOW("slow", "lento", "lento"),
    WORD_NORMAL("normal", "normal", "normal"),
    WORD_FAST("fast", "rápido", "rápido"),
    WORD_INSTANT("instant", "imediato", "imediato");

    private final String english;
    private final String brazilian;
    private final String portuguese;

    Phrase(String english, String brazilian, String portuguese) {
        this.english = english;
        this.brazilian = brazilian;
        this.portuguese = portuguese;
    }

    /** Returns the text in a language. */
    public String in(Language language) {
        return switch (language) {
            case EN -> english;
            case PT_BR -> brazilian;
            case PT_PT -> portuguese;
        };
    }

    /** Returns the text in a language with its placeholders filled, in order. */
    public String in(Language language, Object... values) {
        return String.format(Locale.ROOT, in(language), values);
    }

    /** Returns the name of a setting by its key: {@code invertMouse} is SETTING_INVERT_MOUSE. */
    public static Phrase ofSetting(String key) {
        return valueOf("SETTING_" + key.replaceAll("([A-Z])", "_$1").toUpperCase(Locale.ROOT));
    }

    /** Returns the name of a key, see {@link nephele.app.window.KeyNames}, as keyboards in a language call it. */
    public static String ofKey(String key, Language language) {
        if (key.startsWith("Keypad ")) {
            return KEY_KEYPAD.in(language, ofKey(key.substring("Keypad ".length()), language));
        }
        if (key.startsWith("Mouse ")) {
            return KEY_MOUSE.in(language, key.substring("Mouse ".length()));
        }
        return isSameEverywhere(key)
                ? key
                : valueOf("KEY_" + key.toUpperCase(Locale.ROOT).replace(' ', '_'))
                        .in(language);
    }

    private static boolean isSameEverywhere(String key) {
        return key.length() == 1 || key.matches("F[0-9]+");
    }

    /** Returns a key's name for sentences: mouse buttons are clicks. */
    public static String ofKeyInSentence(String key, Language language) {
        return switch (key) {
            case "Mouse 1" -> LEFT_CLICK.in(language);
            case "Mouse 2" -> RIGHT_CLICK.in(language);
            default -> ofKey(key, language);
        };
    }

    /** Returns the meaning of a control; its placeholder is the key that runs. */
    public static Phrase ofControl(Enum<?> control) {
        return valueOf("CONTROL_" + control.name());
    }

    /** Returns the reason for which a portal was refused. */
    public static Phrase ofRefusal(Enum<?> refusal) {
        return valueOf("REFUSED_" + refusal.name());
    }

    /** Returns the name of a word of a setting. */
    public static Phrase ofWord(Enum<?> word) {
        return valueOf("WORD_" + word.name());
    }
}

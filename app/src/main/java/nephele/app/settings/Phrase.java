package nephele.app.settings;

import java.util.Locale;
import nephele.engine.level.Language;

/** A text of the game in English, Brazilian and European Portuguese. */
public enum Phrase {
    CONTINUE("Continue", "Continuar", "Continuar"),
    BEGIN("Begin", "Começar", "Começar"),
    LEVELS("Levels", "Fases", "Níveis"),
    SAMPLES("Samples", "Exemplos", "Exemplos"),
    YOUR_LEVELS("Your levels", "Suas fases", "Os teus níveis"),
    SHOW_FOLDER("Open the folder", "Abrir a pasta", "Abrir a pasta"),
    FOLDER_NOT_SHOWN("Open this folder yourself: %s", "Abra você mesmo esta pasta: %s", "Abre tu esta pasta: %s"),
    YOUR_LEVELS_HOW(
            "Put levels (.json) and packages (.zip) here:\n%s\nMake them with the editor: nephele edit. It saves into"
                    + " this folder, and each level in it is listed on this page.",
            "Ponha aqui fases (.json) e pacotes (.zip):\n%s\nFaça-os com o editor: nephele edit. Ele salva nesta"
                    + " pasta, e cada fase que está nela aparece nesta página.",
            "Põe aqui níveis (.json) e pacotes (.zip):\n%s\nCria-os com o editor: nephele edit. Ele guarda nesta"
                    + " pasta, e cada nível que está nela aparece nesta página."),
    NO_LEVEL_YET("None yet", "Nenhuma ainda", "Ainda nenhum"),
    NO_LEVELS_FOLDER(
            "There is no folder for them: HOME is not set.",
            "Não há pasta para elas: HOME não está definido.",
            "Não há pasta para eles: HOME não está definido."),
    LEVELS_READ("%s of %s read", "%s de %s lidas", "%s de %s lidos"),
    LEVELS_GOOD("%s in your folder", "%s na sua pasta", "%s na tua pasta"),
    LEVELS_BROKEN("%s in your folder, broken: %s", "%s na sua pasta, com erros: %s", "%s na tua pasta, com erros: %s"),
    BROKEN("broken", "com erros", "com erros"),
    MORE_PROBLEMS("… and %s more", "… e mais %s", "… e mais %s"),
    FILE("File", "Arquivo", "Ficheiro"),
    BEST_TIME("Best time", "Melhor tempo", "Melhor tempo"),
    PORTALS_USED("Portals used", "Portais usados", "Portais usados"),
    PAR("par %s", "meta %s", "meta %s"),
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
    MENU_KEYS("↑ ↓  Enter or mouse", "↑ ↓  Enter ou mouse", "↑ ↓  Enter ou rato"),
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
    NOT_SAVED("Not saved: %s", "Não foi salvo: %s", "Não foi guardado: %s"),
    RECORDED("Recorded %s", "Gravado em %s", "Gravado em %s"),
    NOT_LOADED(
            "The level cannot be loaded: %s",
            "A fase não pode ser carregada: %s", "O nível não pode ser carregado: %s"),
    SCENE_NOT_SHOWN(
            "The scene cannot be shown: %s", "A cena não pode ser mostrada: %s", "A cena não pode ser mostrada: %s"),
    SETTING_LANGUAGE("Language", "Idioma", "Idioma"),
    SETTING_HORIZONTAL_FOV_DEGREES("Field of view", "Campo de visão", "Campo de visão"),
    SETTING_MOUSE_SPEED("Mouse speed", "Velocidade do mouse", "Velocidade do rato"),
    SETTING_INVERT_MOUSE("Invert mouse", "Inverter mouse", "Inverter rato"),
    SETTING_CROUCH("Crouch", "Agachar", "Agachar"),
    SETTING_QUALITY("Quality", "Qualidade", "Qualidade"),
    SETTING_AUTO_FRAME_RATE("Auto: frames/s", "Auto: quadros/s", "Auto: imagens/s"),
    SETTING_WINDOW_MODE("Window", "Janela", "Janela"),
    SETTING_RESOLUTION("Resolution", "Resolução", "Resolução"),
    SETTING_ANTIALIASING("Smooth edges", "Suavizar bordas", "Suavizar arestas"),
    SETTING_VERTICAL_SYNC("Vertical sync", "Sincronia vertical", "Sincronização vertical"),
    SETTING_FRAME_CAP("Frame cap", "Limite de quadros", "Limite de imagens"),
    SETTING_ASSISTS("Help with portals", "Ajuda com portais", "Ajuda com portais"),
    SETTING_UPRIGHT_SPEED("Turning upright", "Endireitar-se", "Endireitar-se"),
    SETTING_REDUCED_MOTION("Reduced motion", "Movimento reduzido", "Movimento reduzido"),
    SETTING_REDUCED_FLASHES("Soft lightning", "Relâmpagos suaves", "Relâmpagos suaves"),
    SETTING_PORTAL_COLOURS("Portal colours", "Cores dos portais", "Cores dos portais"),
    GROUP_PICTURE("Picture", "Imagem", "Imagem"),
    GROUP_WINDOW("Window and frames", "Janela e quadros", "Janela e imagens"),
    GROUP_VIEW("Mouse and view", "Mouse e visão", "Rato e vista"),
    GROUP_COMFORT("Comfort", "Conforto", "Conforto"),
    GROUP_AIDS("Aids", "Ajudas", "Ajudas"),
    ABOUT_PICTURE(
            "How fine the picture is, and how smooth.",
            "A nitidez da imagem e a fluidez do jogo.",
            "A nitidez da imagem e a fluidez do jogo."),
    ABOUT_WINDOW(
            "Window or full screen, its size, and frames a second.",
            "Janela ou tela cheia, seu tamanho, e quadros por segundo.",
            "Janela ou ecrã inteiro, o seu tamanho, e imagens por segundo."),
    ABOUT_VIEW(
            "The mouse, and how much is seen at once.",
            "O mouse, e quanto se vê de uma vez.",
            "O rato, e quanto se vê de uma vez."),
    ABOUT_COMFORT(
            "Motion, flashes and colours that suit your eyes.",
            "Movimento, clarões e cores que convêm aos seus olhos.",
            "Movimento, clarões e cores que convêm aos teus olhos."),
    ABOUT_AIDS(
            "What the game does for your hands.",
            "O que o jogo faz pelas suas mãos.",
            "O que o jogo faz pelas tuas mãos."),
    ABOUT_KEYS(
            "Which key does what. Each can have one of your choice.",
            "Qual tecla faz o quê. Cada ação pode ter uma à sua escolha.",
            "Que tecla faz o quê. Cada ação pode ter uma à tua escolha."),
    HELP_LANGUAGE(
            "The language of menus and messages.",
            "O idioma dos menus e das mensagens.",
            "O idioma dos menus e das mensagens."),
    HELP_HORIZONTAL_FOV_DEGREES(
            "How much is seen from left to right. Wide shows more, narrow looks calmer.",
            "Quanto se vê da esquerda à direita. Largo mostra mais, estreito parece mais calmo.",
            "Quanto se vê da esquerda à direita. Largo mostra mais, estreito parece mais calmo."),
    HELP_MOUSE_SPEED(
            "How far the view turns when the mouse moves.",
            "Quanto a visão gira quando o mouse se move.",
            "Quanto a vista roda quando o rato se move."),
    HELP_INVERT_MOUSE(
            "On: the view turns down when the mouse goes up.",
            "Sim: a visão desce quando o mouse sobe.",
            "Sim: a vista desce quando o rato sobe."),
    HELP_CROUCH(
            "Hold: crouched while the key is down. Toggle: from one press to the next.",
            "Segurar: agachado com a tecla pressionada. Alternar: de um toque ao outro.",
            "Manter: agachado com a tecla premida. Alternar: de um toque ao outro."),
    HELP_QUALITY(
            "How fine the picture is. Auto changes it to keep the game smooth.",
            "A nitidez da imagem. A automática muda para o jogo continuar fluido.",
            "A nitidez da imagem. A automática muda para o jogo continuar fluido."),
    HELP_AUTO_FRAME_RATE(
            "Frames a second that auto quality holds: 60 with a graphics card, 30 without.",
            "Quadros por segundo que a automática mantém: 60 com placa de vídeo, 30 sem.",
            "Imagens por segundo que a automática mantém: 60 com placa gráfica, 30 sem."),
    HELP_ANTIALIASING(
            "Smooths stairs along edges at high quality, over several frames.",
            "Suaviza degraus nas bordas com qualidade alta, ao longo de vários quadros.",
            "Suaviza degraus nas arestas com qualidade alta, ao longo de várias imagens."),
    HELP_WINDOW_MODE(
            "A window, the whole screen without a frame, or full screen.",
            "Uma janela, a tela toda sem moldura, ou tela cheia.",
            "Uma janela, o ecrã todo sem moldura, ou ecrã inteiro."),
    HELP_RESOLUTION(
            "Size of the window, or of the picture in full screen. Auto keeps it.",
            "Tamanho da janela, ou da imagem em tela cheia. Automática o mantém.",
            "Tamanho da janela, ou da imagem em ecrã inteiro. Automática mantém-no."),
    HELP_VERTICAL_SYNC(
            "Each frame waits for the screen, so that the picture does not tear.",
            "Cada quadro espera pela tela, para que a imagem não se rasgue.",
            "Cada imagem espera pelo ecrã, para que não se rasgue."),
    HELP_FRAME_CAP(
            "Most frames a second. Fewer keep the machine cool and quiet.",
            "Máximo de quadros por segundo. Com menos, a máquina fica fria e silenciosa.",
            "Máximo de imagens por segundo. Com menos, a máquina fica fria e silenciosa."),
    HELP_ASSISTS(
            "Help with portals and lost cubes. Holds from the next start on.",
            "Ajuda com portais e cubos perdidos. Vale a partir do próximo início.",
            "Ajuda com portais e cubos perdidos. Vale a partir do próximo início."),
    HELP_UPRIGHT_SPEED(
            "How fast the view turns upright after a portal. Holds from the next start on.",
            "Rapidez com que a visão se endireita após um portal. Vale a partir do próximo início.",
            "Rapidez com que a vista se endireita após um portal. Vale a partir do próximo início."),
    HELP_REDUCED_MOTION(
            "No sway, no dips, no fades. From the next start on the view turns upright at once.",
            "Sem balanço nem escurecimento. A partir do próximo início a visão se endireita logo.",
            "Sem balanço nem escurecimento. A partir do próximo início a vista endireita-se logo."),
    HELP_REDUCED_FLASHES(
            "Lightning and shots are dim and slow, for people whom flashes harm.",
            "Relâmpagos e tiros fracos e lentos, para quem não suporta clarões.",
            "Relâmpagos e tiros fracos e lentos, para quem não suporta clarões."),
    HELP_PORTAL_COLOURS(
            "Colours of your two portals. Choose those that you tell apart best.",
            "Cores dos seus dois portais. Escolha as que melhor distingue.",
            "Cores dos teus dois portais. Escolhe as que melhor distingues."),
    HELP_KEYS(
            "Choose it, then press the key that shall do it. Esc leaves it as it is.",
            "Escolha, e pressione a tecla que o fará. Esc deixa como está.",
            "Escolhe, e prime a tecla que o fará. Esc deixa como está."),
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
    TECHNIQUE_AUTO("auto", "automática", "automática"),
    TECHNIQUE_SKYBOX("skybox", "caixa de céu", "caixa de céu"),
    TECHNIQUE_SKYPLANE("skyplane", "plano de céu", "plano de céu"),
    TECHNIQUE_PROCEDURAL("procedural", "procedural", "procedural"),
    TECHNIQUE_BILLBOARD("billboard", "placas", "placas"),
    TECHNIQUE_PARTICLES("particles", "partículas", "partículas"),
    TECHNIQUE_VOLUME("volume", "volume", "volume"),
    FIGURE_FRAMES("frames a second", "quadros por segundo", "imagens por segundo"),
    FIGURE_FRAME("frame", "quadro", "imagem"),
    FIGURE_DRAWS("draws", "chamadas de desenho", "chamadas de desenho"),
    FIGURE_TRIANGLES("triangles", "triângulos", "triângulos"),
    FIGURE_ALLOCATED("allocated a frame", "memória por quadro", "memória por imagem"),
    FIGURE_TICK("tick", "passo", "passo"),
    FIGURE_QUALITY("quality", "qualidade", "qualidade"),
    FIGURE_QUALITY_AUTO("quality, auto", "qualidade automática", "qualidade automática"),
    FIGURE_SLOWEST("slowest", "mais lento", "mais lenta"),
    FIGURE_OF_BUDGET("%s of %s ms", "%s de %s ms", "%s de %s ms"),
    RESOLUTION_SHARE("resolution %s", "resolução %s", "resolução %s"),
    STEP_BAKED_LIGHT("baked-light", "luz pré-calculada", "luz pré-calculada"),
    STEP_BILLBOARD("billboard", "placas", "placas"),
    STEP_BILLBOARD_BLENDED("billboard.blended", "placas translúcidas", "placas translúcidas"),
    STEP_CLEAR("clear", "limpeza", "limpeza"),
    STEP_CLOUD_SHADE("cloud.shade", "sombra das nuvens", "sombra das nuvens"),
    STEP_CLOUD_SHAFTS("cloud.shafts", "raios entre nuvens", "raios entre nuvens"),
    STEP_CLOUDS("clouds", "nuvens", "nuvens"),
    STEP_DYNAMIC("dynamic", "corpos", "corpos"),
    STEP_DYNAMIC_HELD("dynamic.held", "corpo na mão", "corpo na mão"),
    STEP_EDGE_FILTER("edge-filter", "suavização de bordas", "suavização de arestas"),
    STEP_TEMPORAL("temporal", "média de quadros", "média de fotogramas"),
    STEP_EXIT("exit", "saída", "saída"),
    STEP_EXIT_VEIL("exit.veil", "véu da saída", "véu da saída"),
    STEP_EXPOSURE("exposure", "exposição", "exposição"),
    STEP_GUN("gun", "pistola", "pistola"),
    STEP_GUN_OPENING("gun.opening", "pistola no portal", "pistola no portal"),
    STEP_MUZZLE("muzzle", "luz do disparo", "luz do disparo"),
    STEP_IMPOSTOR("impostor", "impostores", "impostores"),
    STEP_LIGHTNING("lightning", "relâmpagos", "relâmpagos"),
    STEP_PARTICLE("particle", "partículas", "partículas"),
    STEP_PORTAL("portal", "portais", "portais"),
    STEP_PORTAL_DEPTH("portal.depth", "fundo dos portais", "fundo dos portais"),
    STEP_PORTAL_RIM("portal.rim", "bordas dos portais", "aros dos portais"),
    STEP_PORTAL_UNFILLED("portal.unfilled", "portais sem par", "portais sem par"),
    STEP_SHADOW_CONTACT("shadow.contact", "sombra de contato", "sombra de contacto"),
    STEP_SHADOW_DYNAMIC("shadow.dynamic", "sombra dos corpos", "sombra dos corpos"),
    STEP_SHADOW_LIGHTS("shadow.lights", "sombra das luzes", "sombra das luzes"),
    STEP_SHADOW_SUN("shadow.sun", "sombra do sol", "sombra do sol"),
    STEP_SHOT("shot", "disparo", "disparo"),
    STEP_SKY_VISIBILITY("sky-visibility", "visibilidade do céu", "visibilidade do céu"),
    STEP_SKY_ATMOSPHERE("sky.atmosphere", "atmosfera", "atmosfera"),
    STEP_SKY_GRADIENT("sky.gradient", "céu em degradê", "céu em gradiente"),
    STEP_SKY_SKYBOX("sky.skybox", "caixa de céu", "caixa de céu"),
    STEP_SOLID("solid", "sólidos", "sólidos"),
    STEP_TERRAIN("terrain", "terreno", "terreno"),
    STEP_TONEMAP("tonemap", "mapa de tons", "mapa de tons"),
    STEP_UPSCALE("upscale", "ampliação", "ampliação"),
    MOVE_WIPE("move the wipe (%s: finely)", "mover a divisória (%s: devagar)", "mover a divisória (%s: devagar)"),
    WHOLE_SIDE("only the right, the left picture", "só a imagem direita, esquerda", "só a imagem direita, esquerda"),
    KEYS("Keys", "Teclas", "Teclas"),
    VIEWER_MOVE("move", "mover", "mover"),
    VIEWER_FASTER("faster", "mais rápido", "mais depressa"),
    VIEWER_TURN("or drag: turn", "ou arrastar: virar", "ou arrastar: virar"),
    VIEWER_WIREFRAME("wireframe", "só arestas", "só arestas"),
    VIEWER_AXES("axes", "eixos", "eixos"),
    VIEWER_SHADING("shading", "sombreamento", "sombreado"),
    VIEWER_TERMS("light terms", "partes da luz", "partes da luz"),
    VIEWER_PAUSE("pause", "pausa", "pausa"),
    VIEWER_HOME("start again", "recomeçar", "recomeçar"),
    VIEWER_FULL_SCREEN("full screen", "tela cheia", "ecrã inteiro"),
    VIEWER_PICTURE("picture", "imagem", "imagem"),
    VIEWER_KEYS("keys", "teclas", "teclas"),
    VIEWER_LEAVE("leave", "sair", "sair"),
    SCENE_RESTS("The scene stands still", "A cena está parada", "A cena está parada"),
    SCENE_GOES_ON("The scene goes on", "A cena continua", "A cena continua"),
    SHADING_IS("Shading: %s", "Sombreamento: %s", "Sombreado: %s"),
    LIGHT_IS("Light: %s", "Luz: %s", "Luz: %s"),
    WORD_FLAT("flat", "plano", "plano"),
    WORD_GOURAUD("Gouraud", "Gouraud", "Gouraud"),
    WORD_PHONG("Phong", "Phong", "Phong"),
    WORD_WIREFRAME("wireframe", "só arestas", "só arestas"),
    WORD_AMBIENT("ambient", "ambiente", "ambiente"),
    WORD_DIFFUSE("diffuse", "difusa", "difusa"),
    WORD_SPECULAR("specular", "especular", "especular"),
    WORD_EMISSIVE("emissive", "emissiva", "emissiva"),
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
    NO_GOAL("This level names no goal.", "Esta fase não indica um objetivo.", "Este nível não indica um objetivo."),
    HINT_OFFERED("%s: a hint, if you are stuck", "%s: uma dica, se você travou", "%s: uma pista, se não avanças"),
    HINT_GIVEN("Hint %s of %s: %s", "Dica %s de %s: %s", "Pista %s de %s: %s"),
    HINT_COMES("A hint comes in %s", "Uma dica vem em %s", "Uma pista chega dentro de %s"),
    HINT_NEXT("(the next one in %s)", "(a próxima em %s)", "(a próxima dentro de %s)"),
    NO_HINT_HERE(
            "No hint for this place: look around",
            "Sem dica para este lugar: olhe em volta",
            "Sem pista para este lugar: olha em volta"),
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
        return valueOf("SETTING_" + constant(key));
    }

    /** Returns what a setting does, by its key: {@code invertMouse} is HELP_INVERT_MOUSE. */
    public static Phrase ofHelp(String key) {
        return valueOf("HELP_" + constant(key));
    }

    private static String constant(String key) {
        return key.replaceAll("([A-Z])", "_$1").toUpperCase(Locale.ROOT);
    }

    /** Returns the name of a group of settings. */
    public static Phrase ofGroup(Enum<?> group) {
        return valueOf("GROUP_" + group.name());
    }

    /** Returns what a group of settings is about. */
    public static Phrase ofGroupHelp(Enum<?> group) {
        return valueOf("ABOUT_" + group.name());
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

    /** Returns what a step of a frame does, by its name in {@code explain}: {@code sky.skybox} is STEP_SKY_SKYBOX. */
    public static Phrase ofStep(String name) {
        return valueOf("STEP_" + name.toUpperCase(Locale.ROOT).replace('.', '_').replace('-', '_'));
    }

    /** Returns the name of a technique of clouds. */
    public static Phrase ofTechnique(Enum<?> technique) {
        return valueOf("TECHNIQUE_" + technique.name());
    }

    /** Returns the name of a word of a setting. */
    public static Phrase ofWord(Enum<?> word) {
        return valueOf("WORD_" + word.name());
    }
}

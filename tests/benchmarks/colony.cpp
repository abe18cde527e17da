// The yardstick: the colony of acoexp's aco preset as a plain C++ program. Same random numbers, same order of operations,
// so its ants walk the same paths; speed.py checks that and compares the time per ant step. It marks visited cells by a
// ticket, which is a little faster in C++ than the factor that acoexp's kernels use.
//
// Usage: colony MAP TRIALS CYCLES, MAP being what speed.py writes: rows cols start goal, then for each cell of the
// bordered map its allowed moves and its eight desirabilities (eta^beta) in hexadecimal floating point.
// Prints: nanoseconds, ant steps, and a checksum over the best path's length in every cycle.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

struct Colony {
    int rows, cols, width, cells, start, goal;
    int ants = 10, cycles = 200;
    double alpha = 1.1, rho = 0.5, q = 1.0, tau0 = 1.0;
    int offsets[8];
    std::vector<uint8_t> allowed;
    std::vector<double> desirability, stored, weight;
    std::vector<int32_t> visited, stale;
    std::vector<uint8_t> moves;
    std::vector<int> steps, straight;
    std::vector<double> length;
    int ticket = 0;
    double scale = 1.0;
    uint64_t random[4];
    uint64_t checksum = 0, ant_steps = 0;

    static uint64_t rotate(uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    void seed_stream(uint64_t seed) {
        for (int i = 0; i < 4; i++) {
            seed += 0x9E3779B97F4A7C15u;
            uint64_t z = (seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9u;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
            random[i] = z ^ (z >> 31);
        }
    }

    double uniform() {
        uint64_t* s = random;
        uint64_t result = rotate(s[0] + s[3], 23) + s[0], t = s[1] << 17;
        s[2] ^= s[0]; s[3] ^= s[1]; s[1] ^= s[2]; s[0] ^= s[3]; s[2] ^= t; s[3] = rotate(s[3], 45);
        return (result >> 11) * 0x1.0p-53;
    }

    double open_weight(int cell, int direction, int offset) const {
        double w = weight[cell * 8 + direction];
        return visited[cell + offset] != ticket ? w : 0.0;
    }

    bool is_open(int cell, int d) const { return (allowed[cell] >> d & 1) && visited[cell + offsets[d]] != ticket; }

    int choose_rarely(int cell) {
        int count = 0;
        double largest = 0.0;
        for (int d = 0; d < 8; d++)
            if (is_open(cell, d)) {
                double w = weight[cell * 8 + d];
                if (w > largest) { count = 0; largest = w; }
                if (w == largest) count++;
            }
        if (!count) return 8;
        int nth = int(uniform() * count);
        for (int d = 0; d < 8; d++)
            if (is_open(cell, d) && weight[cell * 8 + d] == largest && nth-- == 0) return d;
        return 8;
    }

    int choose(int cell) {
        double w0 = open_weight(cell, 0, 1), w1 = open_weight(cell, 1, 1 - width);
        double w2 = open_weight(cell, 2, -width), w3 = open_weight(cell, 3, -1 - width);
        double w4 = open_weight(cell, 4, -1), w5 = open_weight(cell, 5, width - 1);
        double w6 = open_weight(cell, 6, width), w7 = open_weight(cell, 7, width + 1);
        double s1 = w0 + w1, s5 = w4 + w5, s2 = s1 + w2, s3 = s1 + (w2 + w3), s6 = s5 + w6, s7 = s5 + (w6 + w7);
        double total = s3 + s7, ball = uniform() * total;
        if (!(ball < total)) return choose_rarely(cell);
        return (w0 <= ball) + (s1 <= ball) + (s2 <= ball) + (s3 <= ball) + (s3 + w4 <= ball) + (s3 + s5 <= ball) +
               (s3 + s6 <= ball);
    }

    void walk(int ant) {
        int cell = start, n = 0, straights = 0;
        uint8_t* trail = &moves[size_t(ant) * cells];
        visited[cell] = ++ticket;
        while (cell != goal) {
            int move = choose(cell);
            if (move == 8) { steps[ant] = n; length[ant] = INFINITY; return; }
            trail[n++] = move;
            straights += 1 - (move & 1);
            cell += offsets[move];
            visited[cell] = ticket;
        }
        steps[ant] = n;
        straight[ant] = straights;
        length[ant] = straights + (n - straights) * std::sqrt(2.0);
    }

    void weigh(int edge) { weight[edge] = std::pow(stored[edge], alpha) * desirability[edge]; }

    void refresh() {
        for (int edge : stale) weigh(edge);
        stale.clear();
    }

    void update() {
        scale *= 1.0 - rho;
        if (scale < 1e-100) {
            refresh();
            for (int e = 0; e < cells * 8; e++) { stored[e] *= scale; weigh(e); }
            scale = 1.0;
        }
        for (int ant = 0; ant < ants; ant++) {
            if (length[ant] == INFINITY) continue;
            double share = q / length[ant] / scale;
            int cell = start;
            for (int i = 0; i < steps[ant]; i++) {
                int move = moves[size_t(ant) * cells + i], edge = cell * 8 + move;
                stored[edge] += share;
                if (weight[edge] >= 0.0) { weight[edge] = -1.0; stale.push_back(edge); }
                cell += offsets[move];
            }
        }
        refresh();
    }

    void note_best() {
        int best = 0;
        for (int ant = 1; ant < ants; ant++)
            if (length[ant] < length[best]) best = ant;
        bool arrived = length[best] < INFINITY;
        checksum = checksum * 31 + (arrived ? steps[best] * 1000 + straight[best] : 0);
    }

    void trial(uint64_t seed) {
        seed_stream(seed);
        scale = 1.0;
        ticket = 0;
        double power = std::pow(tau0, alpha);
        for (int e = 0; e < cells * 8; e++) { stored[e] = tau0; weight[e] = power * desirability[e]; }
        visited.assign(cells, 0);
        for (int cycle = 0; cycle < cycles; cycle++) {
            for (int ant = 0; ant < ants; ant++) {
                walk(ant);
                ant_steps += steps[ant];
            }
            update();
            note_best();
        }
    }

    explicit Colony(const char* path) {
        FILE* f = std::fopen(path, "r");
        if (!f || std::fscanf(f, "%d %d %d %d", &rows, &cols, &start, &goal) != 4) std::exit(2);
        width = cols + 2;
        cells = (rows + 2) * width;
        int steps_by_direction[8] = {1, 1 - width, -width, -1 - width, -1, width - 1, width, width + 1};
        for (int d = 0; d < 8; d++) offsets[d] = steps_by_direction[d];
        allowed.resize(cells);
        desirability.resize(cells * 8);
        for (int c = 0; c < cells; c++) {
            int bits;
            if (std::fscanf(f, "%d", &bits) != 1) std::exit(2);
            allowed[c] = bits;
            for (int d = 0; d < 8; d++)
                if (std::fscanf(f, "%la", &desirability[c * 8 + d]) != 1) std::exit(2);
        }
        std::fclose(f);
        stored.resize(cells * 8);
        weight.resize(cells * 8);
        moves.resize(size_t(ants) * cells);
        steps.resize(ants);
        straight.resize(ants);
        length.resize(ants);
    }
};

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    Colony colony(argv[1]);
    colony.cycles = std::atoi(argv[3]);
    auto begin = std::chrono::steady_clock::now();
    for (int seed = 0; seed < std::atoi(argv[2]); seed++) colony.trial(seed);
    auto spent = std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin);
    std::printf("%lld %llu %llu\n", (long long)spent.count(), (unsigned long long)colony.ant_steps,
                (unsigned long long)colony.checksum);
}

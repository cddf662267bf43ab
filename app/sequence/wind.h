#pragma once
// Wind that moves the clouds of a sequence.

#include "app/sequence/job.h"

namespace airlight::cli {

// Lets the wind of the job's preset (clouds[].wind_m_s) move the clouds of its frames. Throws InputError where the
// frames have no time, or where a cloud would stand farther from the camera than a preset may say.
void add_winds(SequenceJob& job);

}  // namespace airlight::cli

// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: MIT
#include "meshimport/worker/reply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

using namespace esm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Five vertices, of which the last is not finite and unused; one of each element.
WorkerReply sample()
{
  WorkerReply reply;
  reply.format = "dae (assimp)";
  reply.notes = {"first note", "second note"};
  reply.mesh.position.resize(3, 5);
  reply.mesh.position << 0, 1, 0, 0, std::numeric_limits<double>::quiet_NaN(), //
    0, 0, 1, 0, 0,                                                             //
    0, 0, 0, 1, 0;
  reply.mesh.triangles.resize(3, 1);
  reply.mesh.triangles << 0, 1, 2;
  reply.mesh.segments.resize(2, 1);
  reply.mesh.segments << 0, 3;
  reply.mesh.tetrahedra.resize(4, 1);
  reply.mesh.tetrahedra << 0, 1, 2, 3;
  reply.mesh.diagonals.resize(2, 1);
  reply.mesh.diagonals << 1, 2;
  return reply;
}

/// The reply with one field of its head replaced.
template <class Field>
std::string withHead(std::string bytes, Field ReplyHead::*field, Field value)
{
  ReplyHead head;
  std::memcpy(&head, bytes.data(), sizeof head);
  head.*field = value;
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}

std::string whyNot(std::string_view bytes)
{
  const auto reply = decodeReply(bytes);
  return reply ? "it was taken" : reply.error().detail;
}

TEST(WorkerReply, arrivesAsItWasSent)
{
  const WorkerReply sent = sample();
  const auto got = decodeReply(encodeReply(sent));
  ASSERT_TRUE(got) << got.error().detail;
  EXPECT_FALSE(got->refusal);
  EXPECT_EQ(got->format, "dae (assimp)");
  EXPECT_THAT(got->notes, ElementsAre("first note", "second note"));
  EXPECT_EQ(got->mesh.position.leftCols(4), sent.mesh.position.leftCols(4));
  EXPECT_EQ(got->mesh.triangles, sent.mesh.triangles);
  EXPECT_EQ(got->mesh.segments, sent.mesh.segments);
  EXPECT_EQ(got->mesh.diagonals, sent.mesh.diagonals);
  EXPECT_EQ(got->mesh.tetrahedra, sent.mesh.tetrahedra);
  EXPECT_TRUE(got->stated.isEmpty());
}

TEST(WorkerReply, carriesWhatTheFileStates)
{
  WorkerReply sent = sample();
  for (const StatedFrame& stated :
       {StatedFrame{0.0254, UpAxis::X, PatientAxes::Ras}, StatedFrame{{}, UpAxis::Y, {}},
        StatedFrame{1e-3, {}, PatientAxes::Lps}}) {
    sent.stated = stated;
    const auto got = decodeReply(encodeReply(sent));
    ASSERT_TRUE(got) << got.error().detail;
    EXPECT_EQ(got->stated, stated);
  }
  const std::string bytes = encodeReply(sent);
  for (const double metres : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::metres, metres)));
  for (const std::int32_t number : {-2, 3, 1 << 30}) {
    EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::up, number)));
    EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::axes, number)));
  }
}

TEST(WorkerReply, carriesARefusalInPlaceOfAMesh)
{
  WorkerReply sent = sample();
  sent.refusal = Error{ErrorCode::EmptyResult, "x.dae: nothing in it"};
  const auto got = decodeReply(encodeReply(sent));
  ASSERT_TRUE(got) << got.error().detail;
  ASSERT_TRUE(got->refusal);
  EXPECT_EQ(got->refusal->code, ErrorCode::EmptyResult);
  EXPECT_EQ(got->refusal->detail, "x.dae: nothing in it");
  EXPECT_EQ(got->mesh.vertexCount(), 0);
}

TEST(WorkerReply, ofAnyOtherLengthIsRefused)
{
  const std::string bytes = encodeReply(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(decodeReply(std::string_view(bytes).substr(0, size))) << size;
  EXPECT_THAT(whyNot(bytes + "x"), HasSubstr("bytes where its head promises"));
}

// Nothing may be allocated by a count alone: 2^61 vertices of 24 bytes would also wrap around to a small
// size.
TEST(WorkerReply, countsThatDidNotArriveAreRefused)
{
  const std::string bytes = encodeReply(sample());
  for (const auto count :
       {std::uint64_t{6}, std::uint64_t{100'000'000}, std::uint64_t{1} << 61, ~std::uint64_t{0}})
    for (const auto field : {&ReplyHead::vertices, &ReplyHead::triangles, &ReplyHead::segments,
                             &ReplyHead::tetrahedra, &ReplyHead::diagonals, &ReplyHead::textBytes})
      EXPECT_NE(whyNot(withHead(bytes, field, count)), "it was taken") << count;
  EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::vertices, std::uint64_t{1} << 61)));
  EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::version, ReplyHead::kVersion + 1)));
  EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::magic, 0u)));
  EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::refusal, std::int64_t{999})));
  EXPECT_FALSE(replySize(withHead(bytes, &ReplyHead::refusal, std::int64_t{0}))) << "a mesh beside a refusal";
}

TEST(WorkerReply, indicesOutOfRangeAndPlacesThatAreNotFiniteAreRefused)
{
  for (const Index bad : {-1, 5, std::numeric_limits<Index>::max(), 4 /* the one that is not finite */}) {
    WorkerReply face = sample(), line = sample(), solid = sample(), cut = sample();
    face.mesh.triangles(2, 0) = bad;
    line.mesh.segments(1, 0) = bad;
    solid.mesh.tetrahedra(3, 0) = bad;
    cut.mesh.diagonals(0, 0) = bad;
    for (const WorkerReply& reply : {face, line, solid, cut})
      EXPECT_THAT(whyNot(encodeReply(reply)), HasSubstr("not there or not finite")) << bad;
  }
}

} // namespace
